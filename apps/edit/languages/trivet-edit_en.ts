<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_GB" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message numerus="yes">
        <source> · %n pairs of faces by %1, %2 confirmed</source>
        <translation>
            <numerusform> · %n pair of faces by %1, %2 confirmed</numerusform>
            <numerusform> · %n pairs of faces by %1, %2 confirmed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>operations</name>
    <message numerus="yes">
        <source>%1 %n objects</source>
        <translation>
            <numerusform>%1 %n object</numerusform>
            <numerusform>%1 %n objects</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>results</name>
    <message numerus="yes">
        <source>%n objects moved, by %1 at most</source>
        <translation>
            <numerusform>%n object moved, by %1 at most</numerusform>
            <numerusform>%n objects moved, by %1 at most</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tools</name>
    <message numerus="yes">
        <source>%n copies</source>
        <translation>
            <numerusform>%n copy</numerusform>
            <numerusform>%n copies</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n objects in turn</source>
        <translation>
            <numerusform>%n object in turn</numerusform>
            <numerusform>%n objects in turn</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trivet::edit::ImportDialog</name>
    <message numerus="yes">
        <source>Import %n models</source>
        <translation>
            <numerusform>Import %n model</numerusform>
            <numerusform>Import %n models</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n files cannot be read and are left out.</source>
        <translation>
            <numerusform>%n file cannot be read and is left out.</numerusform>
            <numerusform>%n files cannot be read and are left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trivet::edit::MainWindow</name>
    <message numerus="yes">
        <source>%n models were not imported: %1</source>
        <translation>
            <numerusform>%n model was not imported: %1</numerusform>
            <numerusform>%n models were not imported: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trivet::edit::Outliner</name>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n object</numerusform>
            <numerusform>%n objects</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trivet::edit::StartPage</name>
    <message numerus="yes">
        <source>%1 was not closed properly; %n steps, the last on %2</source>
        <translation>
            <numerusform>%1 was not closed properly; %n step, the last on %2</numerusform>
            <numerusform>%1 was not closed properly; %n steps, the last on %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wishes</name>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n object</numerusform>
            <numerusform>%n objects</numerusform>
        </translation>
    </message>
</context>
</TS>
