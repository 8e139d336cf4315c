<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>QObject</name>
    <message>
        <source>z-lists in software</source>
        <translation>z-Listen in Software</translation>
    </message>
    <message>
        <source>z-lists: %1</source>
        <translation>z-Listen: %1</translation>
    </message>
    <message>
        <source>automatic: %1</source>
        <translation>automatisch: %1</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> Pixel</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>Sauber</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>nothing stops it</source>
        <translation>nichts hält es auf</translation>
    </message>
    <message>
        <source>inside %1 from the start</source>
        <translation>von Anfang an in %1</translation>
    </message>
    <message>
        <source>stops at &lt;b&gt;%1&lt;/b&gt; after &lt;b&gt;%2&lt;/b&gt;</source>
        <translation>hält an &lt;b&gt;%1&lt;/b&gt; nach &lt;b&gt;%2&lt;/b&gt;</translation>
    </message>
    <message>
        <source> · not before %1, at the latest %2</source>
        <translation> · nicht vor %1, spätestens %2</translation>
    </message>
    <message>
        <source> · %1 of %2 pixels doubtful</source>
        <translation> · %1 von %2 Pixeln fraglich</translation>
    </message>
    <message>
        <source> · %1 ms</source>
        <translation> · %1 ms</translation>
    </message>
    <message>
        <source>unplaced</source>
        <translation>nicht abgelegt</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>stabil</translation>
    </message>
    <message>
        <source>wedged</source>
        <translation>verkeilt</translation>
    </message>
    <message>
        <source>held</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>unsupported</source>
        <translation>ohne Unterlage</translation>
    </message>
    <message>
        <source>invalid</source>
        <translation>ungültig</translation>
    </message>
    <message numerus="yes">
        <source> · %n pairs of faces by %1, %2 confirmed</source>
        <translation>
            <numerusform> · %n Flächenpaar durch %1, %2 bestätigt</numerusform>
            <numerusform> · %n Flächenpaare durch %1, %2 bestätigt</numerusform>
        </translation>
    </message>
    <message>
        <source>The saved choice of collision detection, %1 by %2, is not accepted: it is automatic</source>
        <translation>Die gespeicherte Wahl der Kollisionserkennung, %1 durch %2, gibt es nicht: sie ist automatisch</translation>
    </message>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
</context>
<context>
    <name>assets</name>
    <message>
        <source>%1, likely %2</source>
        <translation>%1, wohl %2</translation>
    </message>
    <message>
        <source>%1 units of %2 m</source>
        <translation>%1 Einheiten von %2 m</translation>
    </message>
    <message>
        <source>up: %1</source>
        <translation>oben: %1</translation>
    </message>
    <message>
        <source>up: %1, likely</source>
        <translation>oben: %1, wohl</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>operations</name>
    <message>
        <source>put</source>
        <translation>hinstellen</translation>
    </message>
    <message>
        <source>push</source>
        <translation>schieben</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>rotate</source>
        <translation>rotieren</translation>
    </message>
    <message>
        <source>append</source>
        <translation>hinzufügen</translation>
    </message>
    <message>
        <source>duplicate</source>
        <translation>verdoppeln</translation>
    </message>
    <message>
        <source>delete</source>
        <translation>löschen</translation>
    </message>
    <message>
        <source>lock</source>
        <translation>sperren</translation>
    </message>
    <message>
        <source>unlock</source>
        <translation>entsperren</translation>
    </message>
    <message>
        <source>fix</source>
        <translation>befestigen</translation>
    </message>
    <message>
        <source>unfix</source>
        <translation>lösen</translation>
    </message>
    <message>
        <source>group</source>
        <translation>gruppieren</translation>
    </message>
    <message>
        <source>ungroup</source>
        <translation>Gruppe auflösen</translation>
    </message>
    <message>
        <source>rename</source>
        <translation>umbenennen</translation>
    </message>
    <message>
        <source>stand</source>
        <translation>genau hinstellen</translation>
    </message>
    <message>
        <source>unplace</source>
        <translation>wegnehmen</translation>
    </message>
    <message>
        <source>material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>arrange</source>
        <translation>anordnen</translation>
    </message>
    <message>
        <source>scale &quot;%1&quot;</source>
        <translation>skalieren „%1“</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 %n objects</source>
        <translation>
            <numerusform>%1: %n Objekt</numerusform>
            <numerusform>%1: %n Objekte</numerusform>
        </translation>
    </message>
    <message>
        <source>pick up</source>
        <translation>aufnehmen</translation>
    </message>
    <message>
        <source>move</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>drape</source>
        <translation>drapieren</translation>
    </message>
    <message>
        <source>mend</source>
        <translation>in Ordnung bringen</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>zur Ruhe bringen</translation>
    </message>
    <message>
        <source>move joint</source>
        <translation>im Gelenk bewegen</translation>
    </message>
</context>
<context>
    <name>refusal</name>
    <message>
        <source>&quot;%1&quot;: its parts stand out of its surface by more than %2 metres in places</source>
        <translation>„%1“: seine Teile ragen stellenweise um mehr als %2 Meter aus seiner Oberfläche</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; has no triangle; accepted: a mesh</source>
        <translation>%1: „%2“ hat kein Dreieck; erlaubt: ein Netz</translation>
    </message>
    <message>
        <source>%1: a layout of Arena is a line of JSON; accepted: .jsonl</source>
        <translation>%1: Ein Layout für Arena ist eine Zeile JSON; zulässig: .jsonl</translation>
    </message>
    <message>
        <source>%1: prints no line of JSON; accepted: {&quot;objects&quot;: [{&quot;name&quot;: ..., &quot;position&quot;: [x, y, z], &quot;rotation&quot;: [w, x, y, z]}, ...]}</source>
        <translation>%1: gibt keine Zeile JSON aus; zulässig: {&quot;objects&quot;: [{&quot;name&quot;: ..., &quot;position&quot;: [x, y, z], &quot;rotation&quot;: [w, x, y, z]}, ...]}</translation>
    </message>
    <message>
        <source>a unit quaternion, w first</source>
        <translation>ein Einheitsquaternion, w zuerst</translation>
    </message>
    <message>
        <source>it does not stand</source>
        <translation>es steht nicht</translation>
    </message>
    <message>
        <source>it stands, but only just: margin %1 metres</source>
        <translation>es steht nur knapp: Spielraum %1 Meter</translation>
    </message>
    <message>
        <source>it touches &quot;%1&quot;, which moved, too</source>
        <translation>es berührt „%1“, das sich auch bewegt hat</translation>
    </message>
    <message>
        <source>its convex parts overlap those of &quot;%1&quot; by %2 metres</source>
        <translation>seine konvexen Teile überlappen die von „%1“ um %2 Meter</translation>
    </message>
    <message>
        <source>no Radiance image: it ends early</source>
        <translation>kein Radiance-Bild: Es endet zu früh</translation>
    </message>
    <message>
        <source>no Radiance image; accepted: #?RADIANCE or #?RGBE, FORMAT=32-bit_rle_rgbe, an empty line, -Y HEIGHT +X WIDTH</source>
        <translation>kein Radiance-Bild; erlaubt: #?RADIANCE oder #?RGBE, FORMAT=32-bit_rle_rgbe, eine leere Zeile, -Y HÖHE +X BREITE</translation>
    </message>
    <message>
        <source>no Radiance image: %1</source>
        <translation>kein Radiance-Bild: %1</translation>
    </message>
    <message>
        <source>no free object is placed; accepted: a scene with one, as a layout of Arena has their poses</source>
        <translation>Kein freies Objekt ist platziert; zulässig: eine Szene mit einem, da ein Layout für Arena ihre Lagen enthält</translation>
    </message>
    <message>
        <source>no object is called &quot;%1&quot;</source>
        <translation>kein Objekt heißt „%1“</translation>
    </message>
    <message>
        <source>the simulator finds no contact with &quot;%1&quot;</source>
        <translation>der Simulator findet keinen Kontakt mit „%1“</translation>
    </message>
    <message>
        <source>this build of trivet reads no Radiance images (libstb-dev was not installed)</source>
        <translation>dieses Trivet liest keine Radiance-Bilder (libstb-dev war nicht installiert)</translation>
    </message>
    <message>
        <source>a Radiance image that repeats pixels; accepted: packed by channel, or not packed</source>
        <translation>ein Radiance-Bild, das Pixel wiederholt; erlaubt: nach Kanälen gepackt oder nicht gepackt</translation>
    </message>
    <message>
        <source>a Radiance image with an exposure of %1</source>
        <translation>ein Radiance-Bild mit einer Belichtung von %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has parts that are turned inside out: its inertia is that of no body, and the nearest one is written</source>
        <translation>„%1“ hat Teile, deren Innenseite außen liegt: Seine Trägheit hat kein Körper; die nächste wird geschrieben</translation>
    </message>
    <message>
        <source>&quot;%1&quot; encloses nothing: it weighs as a sheet of %2 metres, %3 kg</source>
        <translation>„%1“ umschließt nichts: Es wiegt wie ein Blatt von %2 Metern, %3 kg</translation>
    </message>
    <message>
        <source>exposure, noise, strength or f-number of %1; accepted: 0 to 1e6</source>
        <translation>Belichtung, Rauschen, Stärke oder Blendenzahl von %1; erlaubt: 0 bis 1e6</translation>
    </message>
    <message>
        <source>a focus at %1 of the distance; accepted: above 0, to 1e6</source>
        <translation>ein Fokus beim %1-fachen der Entfernung; erlaubt: über 0, bis 1e6</translation>
    </message>
    <message>
        <source>%1 lamps; accepted: at most %2</source>
        <translation>%1 Lampen; erlaubt: höchstens %2</translation>
    </message>
    <message>
        <source>a colour of a lamp is out of range; accepted: 0 to 1e6</source>
        <translation>Die Farbe einer Lampe liegt außerhalb; erlaubt: 0 bis 1e6</translation>
    </message>
    <message>
        <source>a lamp without direction, or a distance or size out of range</source>
        <translation>eine Lampe ohne Richtung, oder ihr Abstand oder ihre Größe liegt außerhalb</translation>
    </message>
    <message>
        <source>%1 kg; accepted: %2 to %3 kg</source>
        <translation>%1 kg; erlaubt: %2 bis %3 kg</translation>
    </message>
    <message>
        <source>a centre beyond %1 m; accepted: coordinates up to that</source>
        <translation>ein Mittelpunkt jenseits von %1 m; erlaubt: Koordinaten bis dahin</translation>
    </message>
    <message>
        <source>an inertia that no rigid body has; accepted: symmetric, positive, no principal moment larger than the sum of the two others</source>
        <translation>ein Trägheitstensor, den kein starrer Körper hat; erlaubt: symmetrisch, positiv, kein Hauptmoment größer als die Summe der beiden anderen</translation>
    </message>
    <message>
        <source>two names</source>
        <translation>zwei Namen</translation>
    </message>
    <message>
        <source>two names, of which one may be &quot;floor&quot;</source>
        <translation>zwei Namen, von denen einer „floor“ sein darf</translation>
    </message>
    <message>
        <source>the name of another object</source>
        <translation>der Name eines anderen Objekts</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>der Boden</translation>
    </message>
    <message>
        <source>%1 is no name; accepted: UTF-8 without control characters, not &quot;floor&quot;</source>
        <translation>%1 ist kein Name; erlaubt: UTF-8 ohne Steuerzeichen, nicht „floor“</translation>
    </message>
    <message>
        <source>there is an object %1 already</source>
        <translation>ein Objekt %1 gibt es schon</translation>
    </message>
    <message>
        <source>the model %1 of %2 was not loaded</source>
        <translation>das Modell %1 von %2 wurde nicht geladen</translation>
    </message>
    <message>
        <source>%1 cannot follow a hand</source>
        <translation>%1 kann keiner Hand folgen</translation>
    </message>
    <message>
        <source>there is no object %1</source>
        <translation>ein Objekt %1 gibt es nicht</translation>
    </message>
    <message>
        <source>there is no object %1 to put %2 on</source>
        <translation>ein Objekt %1, worauf %2 gestellt werden soll, gibt es nicht</translation>
    </message>
    <message>
        <source>%1; did you mean %2?</source>
        <translation>%1; war %2 gemeint?</translation>
    </message>
    <message>
        <source>%1 is fixed and would have to move along: unfix it first</source>
        <translation>%1 ist befestigt und müsste sich mitbewegen: zuerst lösen</translation>
    </message>
    <message>
        <source>%1 is fixed: unfix it first</source>
        <translation>%1 ist befestigt: zuerst lösen</translation>
    </message>
    <message>
        <source>%1 is locked and would have to move along: unlock it first</source>
        <translation>%1 ist gesperrt und müsste sich mitbewegen: zuerst entsperren</translation>
    </message>
    <message>
        <source>%1 is locked: unlock it first</source>
        <translation>%1 ist gesperrt: zuerst entsperren</translation>
    </message>
    <message>
        <source>%1 is not in the scene: put it there first</source>
        <translation>%1 ist nicht in der Szene: zuerst hinstellen</translation>
    </message>
    <message>
        <source>%1 is not in the scene</source>
        <translation>%1 ist nicht in der Szene</translation>
    </message>
    <message>
        <source>there is no floor to put %1 on</source>
        <translation>es gibt keinen Boden für %1</translation>
    </message>
    <message>
        <source>%1 cannot be put on itself or on what it carries</source>
        <translation>%1 kann nicht auf sich selbst stehen, und nicht auf seiner Last</translation>
    </message>
    <message>
        <source>a clearance of %1 m is not between %2 and %3 m for a scene of this size</source>
        <translation>ein Abstand von %1 m liegt nicht zwischen %2 und %3 m, wie für eine Szene dieser Größe nötig</translation>
    </message>
    <message>
        <source>%1 reaches a coordinate of %2 m: the clearance there, %3 m, is too coarse for %4 of %5 m; accepted: coordinates and sizes of scenes up to %6 m</source>
        <translation>%1 reicht bis zur Koordinate %2 m: der Abstand dort, %3 m, ist zu grob für %4 von %5 m; erlaubt: Koordinaten und Größen von Szenen bis %6 m</translation>
    </message>
    <message>
        <source>%1, or a clearance that is asked for, up to %2 m</source>
        <translation>%1, oder ein ausdrücklich gewählter Abstand bis %2 m</translation>
    </message>
    <message>
        <source>%1 passes through %2</source>
        <translation>%1 durchdringt: %2</translation>
    </message>
    <message>
        <source>%1 is inside %2</source>
        <translation>%1 steckt im Innern: %2</translation>
    </message>
    <message>
        <source>%1 would touch %2 in the float32 values of an exported file</source>
        <translation>%1 würde in den float32-Werten einer exportierten Datei berühren: %2</translation>
    </message>
    <message>
        <source>%1 reaches below the floor</source>
        <translation>%1 reicht unter den Boden</translation>
    </message>
    <message>
        <source>%1 would reach below the floor in an exported file</source>
        <translation>%1 würde in einer exportierten Datei unter den Boden reichen</translation>
    </message>
    <message>
        <source>at its start position %1</source>
        <translation>am Anfang der Bewegung: %1</translation>
    </message>
    <message>
        <source>at its position %1</source>
        <translation>in seiner Lage: %1</translation>
    </message>
    <message>
        <source>%1: move it out freely first</source>
        <translation>%1; zuerst frei herausbewegen</translation>
    </message>
    <message>
        <source>%1 touches %2 already</source>
        <translation>%1 berührt schon: %2</translation>
    </message>
    <message>
        <source>%1 slides or tips off what is below it, and would fall for ever</source>
        <translation>%1 rutscht oder kippt von dem, was darunter ist, und fiele ohne Ende</translation>
    </message>
    <message>
        <source>nothing is below %1: it would fall for ever</source>
        <translation>unter %1 ist nichts: es fiele ohne Ende</translation>
    </message>
    <message>
        <source>the scene would not stand at friction %1: %2 would move</source>
        <translation>die Szene stünde bei Reibung %1 nicht; in Bewegung gerieten: %2</translation>
    </message>
    <message>
        <source>%1; %2 starts were tried, up to %3 m from there</source>
        <translation>%1; versucht wurden %2 Anfangslagen, bis zu %3 m entfernt</translation>
    </message>
    <message>
        <source>%1 touches something at its start</source>
        <translation>%1 berührt am Anfang etwas</translation>
    </message>
    <message>
        <source>%1 did not come to rest within %2 motions</source>
        <translation>%1 kam in %2 Bewegungen nicht zur Ruhe</translation>
    </message>
    <message>
        <source>%1 did not get to the end of its way within %2 motions</source>
        <translation>%1 kam in %2 Bewegungen nicht ans Ende seines Wegs</translation>
    </message>
    <message>
        <source>%1 is wedged in the air: it can neither sink further nor be held there</source>
        <translation>%1 klemmt in der Luft: es kann weder weiter sinken noch dort gehalten werden</translation>
    </message>
    <message>
        <source>%1 is wedged against %2: it can neither sink further nor be held there</source>
        <translation>%1 klemmt (an: %2): es kann weder weiter sinken noch dort gehalten werden</translation>
    </message>
    <message>
        <source>%1 is wedged between %2: it can neither sink further nor be held there</source>
        <translation>%1 klemmt (zwischen: %2): es kann weder weiter sinken noch dort gehalten werden</translation>
    </message>
    <message>
        <source>%1 lies on nothing along which it could be pushed</source>
        <translation>%1 liegt auf nichts, worauf es geschoben werden könnte</translation>
    </message>
    <message>
        <source>%1 lies on nothing: there is no contact %2</source>
        <translation>%1 liegt auf nichts: es gibt keinen Kontakt %2</translation>
    </message>
    <message>
        <source>%1 does not touch %2: there is no contact %3</source>
        <translation>%1 berührt nicht: %2; es gibt keinen Kontakt %3</translation>
    </message>
    <message>
        <source>anything</source>
        <translation>irgend etwas</translation>
    </message>
    <message>
        <source>%1 touches %2 in one point: there is no line to turn about</source>
        <translation>%1 berührt in nur einem Punkt: %2; es gibt keine Gerade, um die es sich drehen ließe</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1 cannot be kept %2 m away from everything else: a scene so large is too coarse for its objects, the smallest of which is %3 m; accepted: a distance to keep of up to %4 m</source>
        <translation>%1 kann nicht %2 m Abstand von allem halten: eine so große Szene ist zu grob für ihre Objekte, deren kleinstes %3 m misst; erlaubt: ein Abstand bis %4 m</translation>
    </message>
    <message>
        <source>%1 would come to rest against %2</source>
        <translation>%1 käme nicht frei zur Ruhe; im Weg: %2</translation>
    </message>
    <message>
        <source>%1 would come to rest too near to %2</source>
        <translation>%1 käme zu nahe zur Ruhe; im Weg: %2</translation>
    </message>
    <message>
        <source>%1 fits nowhere on %2 in its region</source>
        <translation>%1 passt nirgends in seinen Bereich (auf: %2)</translation>
    </message>
    <message>
        <source>%1 would come to rest partly outside its region</source>
        <translation>%1 käme teils außerhalb seines Bereichs zur Ruhe</translation>
    </message>
    <message>
        <source>%1 would not stand well: it tips over an edge %2 m away; accepted: %3 m or more</source>
        <translation>%1 stünde nicht gut: es kippt über eine Kante, die %2 m entfernt ist; erlaubt: %3 m oder mehr</translation>
    </message>
    <message>
        <source>%1 would not stand well: it needs friction of %2; accepted: %3 or less</source>
        <translation>%1 stünde nicht gut: nötig ist eine Reibung von %2; erlaubt: %3 oder weniger</translation>
    </message>
    <message>
        <source>no free place for %1 on %2: of %3 places, every %4 m, %5 are over no part of it and %6 are blocked by other objects</source>
        <translation>kein freier Platz für %1 (auf: %2): von %3 Plätzen, alle %4 m, liegen %5 daneben, %6 sind von anderem besetzt</translation>
    </message>
    <message>
        <source>%1; at %2 more it would leave its region</source>
        <translation>%1; an %2 weiteren läge es teils außerhalb seines Bereichs</translation>
    </message>
    <message>
        <source>%1; it was tried at %2 others: first %3</source>
        <translation>%1; an %2 anderen wurde es versucht, zuerst: %3</translation>
    </message>
    <message>
        <source>not tried, because %1 of %2 was refused before</source>
        <translation>nicht versucht, weil vorher abgelehnt wurde: %1 von %2</translation>
    </message>
    <message>
        <source>%1 of %2 was cancelled</source>
        <translation>abgebrochen: %1 von %2</translation>
    </message>
    <message>
        <source>%1 of %2 did not end within %3 s</source>
        <translation>nicht fertig in %3 s: %1 von %2</translation>
    </message>
    <message>
        <source>%1 has no place %2: %3</source>
        <translation>%1 hat keinen Platz %2: %3</translation>
    </message>
    <message>
        <source>%1 has no place: these leave none together: %2</source>
        <translation>%1 hat keinen Platz: diese lassen zusammen keinen: %2</translation>
    </message>
    <message>
        <source>%1 has no place: these leave none together, as things stand: %2</source>
        <translation>%1 hat keinen Platz: diese lassen zusammen keinen, so wie alles steht: %2</translation>
    </message>
    <message>
        <source>%1 has no place: this leaves none: %2</source>
        <translation>%1 hat keinen Platz: dies lässt keinen: %2</translation>
    </message>
    <message>
        <source>%1 has no place: this leaves none, as things stand: %2</source>
        <translation>%1 hat keinen Platz: dies lässt keinen, so wie alles steht: %2</translation>
    </message>
    <message>
        <source>%1; %2 m are missing</source>
        <translation>%1; es fehlen %2 m</translation>
    </message>
    <message>
        <source>%1; the cheapest to drop: %2</source>
        <translation>%1; am billigsten fällt weg: %2</translation>
    </message>
    <message>
        <source>%1 comes to rest nowhere as it is asked for</source>
        <translation>%1 kommt nirgends so zur Ruhe, wie es gewünscht ist</translation>
    </message>
    <message>
        <source>%1 comes to rest nowhere as it is asked for; first: %2</source>
        <translation>%1 kommt nirgends so zur Ruhe, wie es gewünscht ist; zuerst: %2</translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation>%1, Ebene %2</translation>
    </message>
    <message>
        <source>on the floor</source>
        <translation>auf dem Boden</translation>
    </message>
    <message>
        <source>there is no floor</source>
        <translation>es gibt keinen Boden</translation>
    </message>
    <message>
        <source>the head room there is less than its height</source>
        <translation>die Höhe dort ist geringer als seine eigene</translation>
    </message>
    <message>
        <source>%1 does not fit: %2</source>
        <translation>%1 passt nicht: %2</translation>
    </message>
    <message>
        <source>there is room for %1 by %2 of %3 x %4 m with gaps of %5 m, in %6 x %7 m</source>
        <translation>es ist Platz für %1 mal %2 von %3 x %4 m mit Abständen von %5 m, in %6 x %7 m</translation>
    </message>
    <message>
        <source>the highest of them needs %1 m of head room, there is %2 m</source>
        <translation>das höchste von ihnen braucht %1 m Höhe, es sind %2 m</translation>
    </message>
    <message>
        <source>as things come to rest, not: %1</source>
        <translation>so wie alles zur Ruhe kommt, gilt nicht: %1</translation>
    </message>
    <message>
        <source>where it comes to rest, not: %1</source>
        <translation>wo es zur Ruhe kommt, gilt nicht: %1</translation>
    </message>
    <message>
        <source>the arrangement was cancelled</source>
        <translation>das Anordnen wurde abgebrochen</translation>
    </message>
    <message>
        <source>the arrangement did not end in time</source>
        <translation>das Anordnen endete nicht rechtzeitig</translation>
    </message>
    <message>
        <source>things</source>
        <translation>Dinge</translation>
    </message>
    <message>
        <source>the extras of %1 are not valid JSON: %2</source>
        <translation>die Zusätze von %1 sind kein gültiges JSON: %2</translation>
    </message>
    <message>
        <source>the scene has %1 triangles, more than %2 supports</source>
        <translation>die Szene hat %1 Dreiecke, mehr als %2 erlaubt</translation>
    </message>
    <message>
        <source>a mesh without triangles</source>
        <translation>ein Netz ohne Dreiecke</translation>
    </message>
    <message>
        <source>one at least</source>
        <translation>mindestens eines</translation>
    </message>
    <message>
        <source>cannot write %1</source>
        <translation>%1 kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>no extension</source>
        <translation>keine Endung</translation>
    </message>
    <message>
        <source>is not the mesh that Trivet wrote</source>
        <translation>ist nicht das Netz, das Trivet schrieb</translation>
    </message>
    <message>
        <source>is no array in base64 of items of %1 bytes</source>
        <translation>ist keine Liste in base64 aus Einträgen von %1 Bytes</translation>
    </message>
    <message>
        <source>is not the material of each triangle</source>
        <translation>ist nicht das Material jedes Dreiecks</translation>
    </message>
    <message>
        <source>has not 9 numbers per triangle</source>
        <translation>hat nicht 9 Zahlen für jedes Dreieck</translation>
    </message>
    <message>
        <source>the geometry of &quot;%1&quot; is that of the scene file, rounded to float32: the model file is missing or has changed</source>
        <translation>die Geometrie von „%1“ ist die der Szenendatei, auf float32 gerundet: die Modelldatei fehlt oder hat sich geändert</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, which was out of the scene, is left out: &quot;%2&quot; is missing or has changed</source>
        <translation>„%1“, das nicht in der Szene stand, ist weggelassen: „%2“ fehlt oder hat sich geändert</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;: refused: %3</source>
        <translation>%1 „%2“: abgelehnt: %3</translation>
    </message>
    <message>
        <source>the last line of &quot;%1&quot; is torn: its operation was never committed, and is left out</source>
        <translation>die letzte Zeile von „%1“ ist abgerissen: ihre Operation wurde nie übernommen, und ist weggelassen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not give the same scene to the bit</source>
        <translation>„%1“ ergibt nicht auf das Bit dieselbe Szene</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is restored up to here: %2</source>
        <translation>„%1“ ist bis hierher wiederhergestellt: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is of an earlier version, and its steps are done again by this one</source>
        <translation>„%1“ stammt von einer früheren Version, und seine Schritte werden von dieser noch einmal getan</translation>
    </message>
    <message>
        <source>the result is not the same to the bit</source>
        <translation>das Ergebnis ist nicht auf das Bit dasselbe</translation>
    </message>
    <message>
        <source>there is nothing to undo or redo</source>
        <translation>es gibt nichts rückgängig zu machen oder zu wiederholen</translation>
    </message>
    <message>
        <source>16 hexadecimal digits</source>
        <translation>16 hexadezimale Ziffern</translation>
    </message>
    <message>
        <source>%1; BVHs are used instead</source>
        <translation>%1; stattdessen antworten Boxbäume</translation>
    </message>
    <message>
        <source>demos need a recovery folder for their files, and this editor has none</source>
        <translation>Demos brauchen für ihre Dateien einen Ordner zur Wiederherstellung, und dieser Editor hat keinen</translation>
    </message>
    <message>
        <source>wishes: accepted: a section &quot;arrange&quot;, as trivet schema arrange has it</source>
        <translation>Wünsche: erlaubt: ein Abschnitt „arrange“, wie trivet schema arrange ihn beschreibt</translation>
    </message>
    <message>
        <source>the picture of %1 x %2 pixels cannot be encoded as PNG: %3</source>
        <translation>das Bild von %1 x %2 Pixeln lässt sich nicht als PNG kodieren: %3</translation>
    </message>
    <message>
        <source>%1; accepted: %2</source>
        <translation>%1; erlaubt: %2</translation>
    </message>
    <message>
        <source>&quot;listed&quot; or &quot;any&quot;</source>
        <translation>&quot;listed&quot; oder &quot;any&quot;</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>der Datenträger ist schreibgeschützt</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>ist kein Ordner</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>die Datei gibt es schon</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Fehler beim Lesen oder Schreiben</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>zu viele offene Dateien</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>nicht genug Speicher</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing; required: %2</source>
        <translation>der Schlüssel „%1“ fehlt; nötig: %2</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing</source>
        <translation>der Schlüssel „%1“ fehlt</translation>
    </message>
    <message>
        <source>an object with the keys %1</source>
        <translation>ein Objekt mit den Schlüsseln %1</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>an array of %1 numbers</source>
        <translation>eine Liste aus %1 Zahlen</translation>
    </message>
    <message>
        <source>an array of at least one operation</source>
        <translation>eine Liste mit mindestens einer Operation</translation>
    </message>
    <message>
        <source>text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>text or a number</source>
        <translation>ein Text oder eine Zahl</translation>
    </message>
    <message>
        <source>text of at least one character, without control characters</source>
        <translation>ein Text aus mindestens einem Zeichen, ohne Steuerzeichen</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a quaternion [w, x, y, z] whose length is not zero</source>
        <translation>ein Quaternion [w, x, y, z], dessen Länge nicht null ist</translation>
    </message>
    <message>
        <source>any name but &quot;floor&quot;, which is the floor</source>
        <translation>jeder Name außer „floor“, dem Boden</translation>
    </message>
    <message>
        <source>an object with the keys op, object, ...</source>
        <translation>ein Objekt mit den Schlüsseln op, object, ...</translation>
    </message>
    <message>
        <source>the name of one of /objects</source>
        <translation>der Name eines von /objects</translation>
    </message>
    <message>
        <source>&quot;floor&quot; or the name of one of /objects</source>
        <translation>&quot;floor&quot; oder der Name eines von /objects</translation>
    </message>
    <message>
        <source>%1, the version of the layout format</source>
        <translation>%1, die Version des Layoutformats</translation>
    </message>
    <message>
        <source>there is no &quot;scene&quot; for it</source>
        <translation>es gibt keine „scene“ dafür</translation>
    </message>
    <message>
        <source>one material at least</source>
        <translation>mindestens ein Material</translation>
    </message>
    <message>
        <source>each object once</source>
        <translation>jedes Objekt einmal</translation>
    </message>
    <message>
        <source>at least one object</source>
        <translation>mindestens ein Objekt</translation>
    </message>
    <message>
        <source>&quot;upright&quot;, &quot;as_modelled&quot;, &quot;free&quot;, &quot;stable&quot;, &quot;side&quot; or the number of a stable pose, as trivet info --poses has them</source>
        <translation>&quot;upright&quot;, &quot;as_modelled&quot;, &quot;free&quot;, &quot;stable&quot;, &quot;side&quot; oder die Nummer einer stabilen Lage, wie trivet info --poses sie nennt</translation>
    </message>
    <message>
        <source>an object of names and their fronts</source>
        <translation>ein Objekt aus Namen und ihren Vorderseiten</translation>
    </message>
    <message>
        <source>an object of names and numbers of surfaces</source>
        <translation>ein Objekt aus Namen und Nummern von Flächen</translation>
    </message>
    <message>
        <source>an object of names and their surfaces</source>
        <translation>ein Objekt aus Namen und ihren Flächen</translation>
    </message>
    <message>
        <source>an object of names and lists of zones</source>
        <translation>ein Objekt aus Namen und Listen von Zonen</translation>
    </message>
    <message>
        <source>an object of names and their %1</source>
        <translation>ein Objekt aus Namen und ihren %1</translation>
    </message>
    <message>
        <source>two corners [x, y, z]</source>
        <translation>zwei Ecken [x, y, z]</translation>
    </message>
    <message>
        <source>the lower corner first, the upper one 1 mm beyond it or more</source>
        <translation>zuerst die untere Ecke, die obere mindestens 1 mm darüber hinaus</translation>
    </message>
    <message>
        <source>an object, as trivet schema arrange has it</source>
        <translation>ein Objekt, wie trivet schema arrange es beschreibt</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>at least one block {&quot;things&quot;, &quot;wide&quot;}</source>
        <translation>mindestens ein Block {&quot;things&quot;, &quot;wide&quot;}</translation>
    </message>
    <message>
        <source>a point 1 mm or more from the one before it</source>
        <translation>ein Punkt mindestens 1 mm von dem vor ihm</translation>
    </message>
    <message>
        <source>at least two points [x, y]</source>
        <translation>mindestens zwei Punkte [x, y]</translation>
    </message>
    <message>
        <source>2 opposite corners [x, y] of a rectangle, or at least 3 of a convex polygon, counter-clockwise</source>
        <translation>2 gegenüberliegende Ecken [x, y] eines Rechtecks oder mindestens 3 eines konvexen Vielecks, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>a direction [x, y] whose length is not zero</source>
        <translation>eine Richtung [x, y], deren Länge nicht null ist</translation>
    </message>
    <message>
        <source>[least, most] with the least first</source>
        <translation>[least, most] mit dem kleinsten zuerst</translation>
    </message>
    <message>
        <source>a number, or [least, most]</source>
        <translation>eine Zahl, oder [least, most]</translation>
    </message>
    <message>
        <source>another object than a</source>
        <translation>ein anderes Objekt als a</translation>
    </message>
    <message>
        <source>two names or patterns</source>
        <translation>zwei Namen oder Muster</translation>
    </message>
    <message>
        <source>&quot;top&quot;, &quot;bottom&quot;, or a number as trivet info --surfaces has them, from above if negative</source>
        <translation>&quot;top&quot;, &quot;bottom&quot;, oder eine Nummer, wie trivet info --surfaces sie nennt, von oben, wenn negativ</translation>
    </message>
    <message>
        <source>a problem of trivet arrange or its section &quot;arrange&quot;, an object</source>
        <translation>ein Problem von trivet arrange oder sein Abschnitt „arrange“, ein Objekt</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>die Datei gibt es nicht</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>lässt sich nicht lesen: %1</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>lässt sich nicht bis zum Ende lesen</translation>
    </message>
    <message>
        <source>is a folder, not a model file</source>
        <translation>ist ein Ordner, keine Modelldatei</translation>
    </message>
    <message>
        <source>is a folder, not a scene file</source>
        <translation>ist ein Ordner, keine Szenendatei</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>%1 bytes, more than the limit of %2</source>
        <translation>%1 Bytes, mehr als die Grenze von %2</translation>
    </message>
    <message>
        <source>has no file extension</source>
        <translation>hat keine Endung</translation>
    </message>
    <message>
        <source>no importer for %1</source>
        <translation>Dateien %1 werden nicht gelesen</translation>
    </message>
    <message>
        <source>.obj, .ply, .stl, .gltf, .glb, .fbx, .dae, .3ds, .step, .iges, .brep and others</source>
        <translation>.obj, .ply, .stl, .gltf, .glb, .fbx, .dae, .3ds, .step, .iges, .brep und andere</translation>
    </message>
    <message>
        <source>cannot be read as a model: %1</source>
        <translation>lässt sich nicht als Modell lesen: %1</translation>
    </message>
    <message>
        <source>is truncated: a file of %1 bytes cannot hold %2 elements &quot;%3&quot;</source>
        <translation>ist abgeschnitten: eine Datei von %1 Bytes kann nicht %2 Elemente „%3“ enthalten</translation>
    </message>
    <message>
        <source>is truncated: %1 of %2 lines of PLY data</source>
        <translation>ist abgeschnitten: %1 von %2 Zeilen an PLY-Daten</translation>
    </message>
    <message>
        <source>is truncated: %1 bytes of %2</source>
        <translation>ist abgeschnitten: %1 Bytes von %2</translation>
    </message>
    <message>
        <source>%1 files are read only by the program trivet-import-cad, never in this process</source>
        <translation>%1-Dateien liest nur das Programm trivet-import-cad, nie dieser Prozess</translation>
    </message>
    <message>
        <source>runs out of memory; the file is broken or too large</source>
        <translation>der Speicher reicht nicht; die Datei ist beschädigt oder zu groß</translation>
    </message>
    <message>
        <source>runs out of memory; the chord is too small or the file is broken</source>
        <translation>der Speicher reicht nicht; die Sehne ist zu klein, oder die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>mesh %1: face %2</source>
        <translation>Netz %1: Fläche %2</translation>
    </message>
    <message>
        <source>mesh &apos;%1&apos;: face %2</source>
        <translation>Netz „%1“: Fläche %2</translation>
    </message>
    <message>
        <source>%1 refers to vertex %2 of %3</source>
        <translation>%1 verweist auf Ecke %2 von %3</translation>
    </message>
    <message>
        <source>contains no triangle</source>
        <translation>enthält kein Dreieck</translation>
    </message>
    <message>
        <source>contains no triangle (%1)</source>
        <translation>enthält kein Dreieck (%1)</translation>
    </message>
    <message>
        <source>nodes are nested too deeply</source>
        <translation>Knoten sind zu tief verschachtelt</translation>
    </message>
    <message>
        <source>a node&apos;s transform is not affine</source>
        <translation>die Transformation eines Knotens ist nicht affin</translation>
    </message>
    <message>
        <source>gives more than %1 triangles, the limit, at a chord of %2</source>
        <translation>ergibt mehr als %1 Dreiecke, die Grenze, bei einer Sehne von %2</translation>
    </message>
    <message>
        <source>has coordinates that are not finite</source>
        <translation>hat Koordinaten, die nicht endlich sind</translation>
    </message>
    <message>
        <source>has no surface</source>
        <translation>hat keine Oberfläche</translation>
    </message>
    <message>
        <source>cannot be read as %1</source>
        <translation>lässt sich nicht als %1 lesen</translation>
    </message>
    <message>
        <source>is not binary glTF: it does not begin with &apos;glTF&apos;</source>
        <translation>ist kein binäres glTF: es beginnt nicht mit „glTF“</translation>
    </message>
    <message>
        <source>is not binary glTF: only %1 bytes</source>
        <translation>ist kein binäres glTF: nur %1 Bytes</translation>
    </message>
    <message>
        <source>the first glTF chunk is not JSON</source>
        <translation>der erste Abschnitt des glTF ist kein JSON</translation>
    </message>
    <message>
        <source>the glTF JSON chunk is longer than the file</source>
        <translation>der JSON-Abschnitt des glTF ist länger als die Datei</translation>
    </message>
    <message>
        <source>the scene needs %1 bytes, more than the 4 GiB limit of binary glTF</source>
        <translation>die Szene braucht %1 Bytes, mehr als die Grenze von 4 GiB von binärem glTF</translation>
    </message>
    <message>
        <source>its nodes do not form a tree, or nest too deeply</source>
        <translation>seine Knoten bilden keinen Baum, oder sind zu tief verschachtelt</translation>
    </message>
    <message>
        <source>a buffer view extends beyond its buffer</source>
        <translation>eine Puffersicht reicht über ihren Puffer hinaus</translation>
    </message>
    <message>
        <source>a buffer view refers to a missing buffer</source>
        <translation>eine Puffersicht verweist auf einen Puffer, den es nicht gibt</translation>
    </message>
    <message>
        <source>the JSON has no &quot;asset&quot; object</source>
        <translation>das JSON hat kein Objekt „asset“</translation>
    </message>
    <message>
        <source>buffer %1 has %2 bytes, expected %3</source>
        <translation>Puffer %1 hat %2 Bytes, erwartet sind %3</translation>
    </message>
    <message>
        <source>the buffers exceed the limit</source>
        <translation>die Puffer überschreiten die Grenze</translation>
    </message>
    <message>
        <source>an image is not an object</source>
        <translation>ein Bild ist kein Objekt</translation>
    </message>
    <message>
        <source>refers to element %1 of &quot;%2&quot;, which has %3</source>
        <translation>verweist auf Element %1 von „%2“, das %3 hat</translation>
    </message>
    <message>
        <source>element %1 of &quot;%2&quot; is not an object</source>
        <translation>Element %1 von „%2“ ist kein Objekt</translation>
    </message>
    <message>
        <source>%1 is not an index or a size</source>
        <translation>%1 ist weder Nummer noch Größe</translation>
    </message>
    <message>
        <source>positions that are not plain float32</source>
        <translation>Positionen, die nicht einfaches float32 sind</translation>
    </message>
    <message>
        <source>the importer&apos;s answer is incomplete</source>
        <translation>die Antwort des Leseprogramms ist unvollständig</translation>
    </message>
    <message>
        <source>reading it was cancelled</source>
        <translation>das Lesen wurde abgebrochen</translation>
    </message>
    <message>
        <source>reading it took longer than the limit of %1 s</source>
        <translation>das Lesen dauerte länger als die Grenze von %1 s</translation>
    </message>
    <message>
        <source>output exceeds the memory limit</source>
        <translation>die Ausgabe überschreitet die Speichergrenze</translation>
    </message>
    <message>
        <source>status %1</source>
        <translation>Status %1</translation>
    </message>
    <message>
        <source>the file&apos;s up axis is neither +y nor +z; z is assumed</source>
        <translation>die Achse der Datei nach oben ist weder +y noch +z; z wird angenommen</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>weggelassen: %1</translation>
    </message>
    <message>
        <source>hierarchy and textures left out: %1</source>
        <translation>Hierarchie und Texturen weggelassen: %1</translation>
    </message>
    <message>
        <source>the image &quot;%1&quot;, missing, outside the model&apos;s folder, or neither PNG, JPEG nor WebP</source>
        <translation>das Bild „%1“, das fehlt, außerhalb des Modellordners liegt, oder weder PNG, JPEG noch WebP ist</translation>
    </message>
    <message>
        <source>the extension %1</source>
        <translation>die Erweiterung %1</translation>
    </message>
    <message>
        <source>skins (geometry is in bind pose)</source>
        <translation>Skins (die Geometrie ist in Grundstellung)</translation>
    </message>
    <message>
        <source>morph target weights</source>
        <translation>Gewichte von Morph-Zielen</translation>
    </message>
    <message>
        <source>bump maps</source>
        <translation>Höhentexturen</translation>
    </message>
    <message>
        <source>maps of metalness</source>
        <translation>Texturen des Metallischen</translation>
    </message>
    <message>
        <source>maps of roughness</source>
        <translation>Texturen der Rauheit</translation>
    </message>
    <message>
        <source>maps of specular colour</source>
        <translation>Texturen der Glanzfarbe</translation>
    </message>
    <message>
        <source>not drawn: the image &quot;%1&quot; %2</source>
        <translation>nicht gezeichnet: das Bild „%1“ %2</translation>
    </message>
    <message>
        <source>is a damaged JPEG: %1</source>
        <translation>ist ein beschädigtes JPEG: %1</translation>
    </message>
    <message>
        <source>is a damaged PNG: %1</source>
        <translation>ist ein beschädigtes PNG: %1</translation>
    </message>
    <message>
        <source>is a damaged WebP: its header cannot be read</source>
        <translation>ist ein beschädigtes WebP: sein Kopf ist nicht lesbar</translation>
    </message>
    <message>
        <source>is a damaged WebP</source>
        <translation>ist ein beschädigtes WebP</translation>
    </message>
    <message>
        <source>an accessor has the component type %1</source>
        <translation>ein Accessor hat den Komponententyp %1</translation>
    </message>
    <message>
        <source>an accessor is no scalar and no vector</source>
        <translation>ein Accessor ist weder Skalar noch Vektor</translation>
    </message>
    <message>
        <source>an accessor extends beyond its buffer</source>
        <translation>ein Accessor reicht über seinen Puffer hinaus</translation>
    </message>
    <message>
        <source>its Draco data has no attribute %1</source>
        <translation>seine Draco-Daten haben kein Attribut %1</translation>
    </message>
    <message>
        <source>its Draco data is damaged: %1</source>
        <translation>seine Draco-Daten sind beschädigt: %1</translation>
    </message>
    <message>
        <source>an entry of &quot;extensionsRequired&quot; is no text</source>
        <translation>ein Eintrag von &quot;extensionsRequired&quot; ist kein Text</translation>
    </message>
    <message>
        <source>positions and normals that are no vectors of 3</source>
        <translation>Positionen und Normalen, die keine Vektoren mit 3 Zahlen sind</translation>
    </message>
    <message>
        <source>its nodes do not form a tree: two have node %1 among their children</source>
        <translation>seine Knoten bilden keinen Baum: zwei haben Knoten %1 unter ihren Kindern</translation>
    </message>
    <message>
        <source>a compressed buffer view %1</source>
        <translation>ein komprimierter Puffer-Ausschnitt %1</translation>
    </message>
    <message>
        <source>of mode %1 and filter %2 has %3 items of %4 bytes</source>
        <translation>mit Modus %1 und Filter %2 hat %3 Einträge von %4 Bytes</translation>
    </message>
    <message>
        <source>has the mode %1</source>
        <translation>hat den Modus %1</translation>
    </message>
    <message>
        <source>of %1 bytes claims to hold %2 items of %3</source>
        <translation>von %1 Bytes soll %2 Einträge von %3 enthalten</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>ist beschädigt</translation>
    </message>
    <message>
        <source>other scenes left out: %1 (%2)</source>
        <translation>weggelassene andere Szenen: %1 (%2)</translation>
    </message>
    <message>
        <source>has more than %1 instances, the limit</source>
        <translation>hat mehr als %1 Instanzen, die Grenze</translation>
    </message>
    <message>
        <source>instances have a %1 of %2 components</source>
        <translation>Instanzen haben %1 mit %2 Komponenten</translation>
    </message>
    <message>
        <source>instances have %1 values of %2 for %3 instances</source>
        <translation>Instanzen haben %1 Werte von %2 für %3 Instanzen</translation>
    </message>
    <message>
        <source>instance %1 has a %2 that is not finite</source>
        <translation>Instanz %1 hat %2, das nicht endlich ist</translation>
    </message>
    <message>
        <source>a buffer view that is compressed</source>
        <translation>ein Puffer-Ausschnitt, der komprimiert ist</translation>
    </message>
    <message>
        <source>instances by extension</source>
        <translation>Instanzen durch eine Erweiterung</translation>
    </message>
    <message>
        <source>a mesh that is compressed by Draco</source>
        <translation>ein Netz, das mit Draco komprimiert ist</translation>
    </message>
    <message>
        <source>a sparse accessor of %1 items replaces item %2</source>
        <translation>ein dünn besetzter Accessor mit %1 Einträgen ersetzt Eintrag %2</translation>
    </message>
    <message>
        <source>index %1 refers to vertex %2 of %3</source>
        <translation>Index %1 verweist auf Ecke %2 von %3</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which is missing</source>
        <translation>nennt „%1“, das fehlt</translation>
    </message>
    <message>
        <source>mesh &apos;%1&apos;, primitive %2: %3</source>
        <translation>Netz &apos;%1&apos;, Primitiv %2: %3</translation>
    </message>
    <message>
        <source> after the transform of its node</source>
        <translation> nach der Transformation ihres Knotens</translation>
    </message>
    <message>
        <source> or %1</source>
        <translation> oder %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not stand upright: it has no stable pose</source>
        <translation>„%1“ steht nicht aufrecht: es hat keine stabile Lage</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not stand upright: its nearest stable pose is tilted by %2 degrees</source>
        <translation>„%1“ steht nicht aufrecht: seine nächste stabile Lage ist um %2 Grad gekippt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no curved surfaces; accepted: with models in STEP, IGES or BREP (.step .stp .iges .igs .brep .brp)</source>
        <translation>„%1“ hat keine gekrümmten Flächen; erlaubt: bei Modellen in STEP, IGES oder BREP (.step .stp .iges .igs .brep .brp)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no size and so no mass; it cannot be simulated</source>
        <translation>„%1“ hat keine Größe und damit keine Masse; es lässt sich nicht simulieren</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2: it will move</source>
        <translation>„%1“ ist %2: es wird sich bewegen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2; accepted: numbers from 0</source>
        <translation>„%1“ ist %2; erlaubt: Zahlen ab 0</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is already the name of a camera</source>
        <translation>„%1“ ist schon der Name einer Kamera</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is named before; accepted: each object once</source>
        <translation>„%1“ ist schon genannt; erlaubt: jedes Objekt einmal</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no format of one file; accepted are .glb, .ply and .stl</source>
        <translation>„%1“ ist kein Format aus einer Datei; erlaubt sind .glb, .ply und .stl</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not accepted; accepted: fitted, hull, components, decomposition, mesh</source>
        <translation>„%1“ ist nicht erlaubt; erlaubt: fitted, hull, components, decomposition, mesh</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs friction %2, its contacts have %3: it will move</source>
        <translation>„%1“ braucht die Reibung %2, seine Kontakte haben %3: es wird sich bewegen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was moved</source>
        <translation>„%1“ wurde bewegt</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: its images of normals are left out; files of simulators get base colours alone</source>
        <translation>„%1“: seine Bilder der Normalen fehlen; Dateien für Simulatoren bekommen nur Grundfarben</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: its images of roughness and metal are left out; files of simulators get base colours alone</source>
        <translation>„%1“: seine Bilder von Rauheit und Metall fehlen; Dateien für Simulatoren bekommen nur Grundfarben</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: its images of light of its own are left out; files of simulators get base colours alone</source>
        <translation>„%1“: seine Bilder eigenen Lichts fehlen; Dateien für Simulatoren bekommen nur Grundfarben</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: its colours of vertices are left out; files of simulators get base colours alone</source>
        <translation>„%1“: die Farben seiner Ecken fehlen; Dateien für Simulatoren bekommen nur Grundfarben</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: its triangles collide, as no convex parts leave room for others</source>
        <translation>„%1“: seine Dreiecke stoßen an, da keine konvexen Teile anderen Platz lassen</translation>
    </message>
    <message>
        <source>&quot;floor&quot; or the name of one of /objects%1</source>
        <translation>&quot;floor&quot; oder der Name eines von /objects%1</translation>
    </message>
    <message>
        <source>&quot;format&quot; is %1; accepted: 3</source>
        <translation>„format“ ist %1; erlaubt: 3</translation>
    </message>
    <message>
        <source>&quot;front&quot;, &quot;back&quot;, &quot;left&quot; or &quot;right&quot;</source>
        <translation>&quot;front&quot;, &quot;back&quot;, &quot;left&quot; oder &quot;right&quot;</translation>
    </message>
    <message>
        <source>&quot;right&quot;, &quot;left&quot;, &quot;onwards&quot; or &quot;back&quot;</source>
        <translation>&quot;right&quot;, &quot;left&quot;, &quot;onwards&quot; oder &quot;back&quot;</translation>
    </message>
    <message>
        <source>&quot;unplaced&quot;, &quot;fixed&quot;, &quot;stable&quot;, &quot;wedged&quot;, &quot;held&quot;, &quot;unsupported&quot; or &quot;invalid&quot;</source>
        <translation>&quot;unplaced&quot;, &quot;fixed&quot;, &quot;stable&quot;, &quot;wedged&quot;, &quot;held&quot;, &quot;unsupported&quot; oder &quot;invalid&quot;</translation>
    </message>
    <message>
        <source>&quot;x&quot;, &quot;-x&quot;, &quot;y&quot; or &quot;-y&quot;</source>
        <translation>&quot;x&quot;, &quot;-x&quot;, &quot;y&quot; oder &quot;-y&quot;</translation>
    </message>
    <message>
        <source>&quot;x&quot;, &quot;y&quot; or &quot;both&quot;</source>
        <translation>&quot;x&quot;, &quot;y&quot; oder &quot;both&quot;</translation>
    </message>
    <message>
        <source>&quot;y&quot; or &quot;z&quot;</source>
        <translation>&quot;y&quot; oder &quot;z&quot;</translation>
    </message>
    <message>
        <source>%1 %2 m from %3</source>
        <translation>%1 %2 m von %3</translation>
    </message>
    <message>
        <source>%1 against %2</source>
        <translation>%1 mit dem Rücken an %2</translation>
    </message>
    <message>
        <source>%1 aligned %2</source>
        <translation>%1 ausgerichtet an %2</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>%1 at its point</source>
        <translation>%1 bei seinem Punkt</translation>
    </message>
    <message>
        <source>%1 at_edge %2</source>
        <translation>%1 am Rand von %2</translation>
    </message>
    <message>
        <source>%1 away %2</source>
        <translation>%1 abgewandt von %2</translation>
    </message>
    <message>
        <source>%1 away its point</source>
        <translation>%1 abgewandt von seinem Punkt</translation>
    </message>
    <message>
        <source>%1 behind %2</source>
        <translation>%1 hinter %2</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2</source>
        <translation>%1 lässt sich nicht anlegen: %2</translation>
    </message>
    <message>
        <source>%1 cannot be moved: %2</source>
        <translation>%1 lässt sich nicht bewegen: %2</translation>
    </message>
    <message>
        <source>%1 cannot be read, or is empty</source>
        <translation>%1 lässt sich nicht lesen, oder ist leer</translation>
    </message>
    <message>
        <source>%1 centred %2</source>
        <translation>%1 mittig auf %2</translation>
    </message>
    <message>
        <source>%1 clear of %2</source>
        <translation>%1 frei von %2</translation>
    </message>
    <message>
        <source>%1 comes to rest on %2</source>
        <translation>%1 kommt auf %2 zur Ruhe</translation>
    </message>
    <message>
        <source>%1 comes too near to %2</source>
        <translation>%1 kommt %2 zu nahe</translation>
    </message>
    <message>
        <source>%1 does not compute differences exactly</source>
        <translation>%1 berechnet Differenzen nicht exakt</translation>
    </message>
    <message>
        <source>%1 does not fit between %2 and %3, as things stand: they leave %4, it needs %5 m</source>
        <translation>%1 passt nicht zwischen %2 und %3, wie die Dinge stehen: sie lassen %4, es braucht %5 m</translation>
    </message>
    <message>
        <source>%1 does not fit between %2 and %3: they leave %4, it needs %5 m</source>
        <translation>%1 passt nicht zwischen %2 und %3: sie lassen %4, es braucht %5 m</translation>
    </message>
    <message>
        <source>%1 does not lie on its side: it has no stable pose with its up within 30 degrees of level</source>
        <translation>%1 liegt nicht auf der Seite: es hat keine stabile Lage, deren Oben höchstens 30 Grad von der Waagerechten abweicht</translation>
    </message>
    <message>
        <source>%1 does not rest on %2 alone</source>
        <translation>%1 ruht nicht auf %2 allein</translation>
    </message>
    <message>
        <source>%1 does not rest on what it is to rest on</source>
        <translation>%1 ruht nicht auf dem, worauf es ruhen soll</translation>
    </message>
    <message>
        <source>%1 facing %2</source>
        <translation>%1 zugewandt %2</translation>
    </message>
    <message>
        <source>%1 facing its point</source>
        <translation>%1 zugewandt seinem Punkt</translation>
    </message>
    <message>
        <source>%1 fails its self-test: %2</source>
        <translation>%1 besteht seine Selbstprüfung nicht: %2</translation>
    </message>
    <message>
        <source>%1 flat parts get a thickness of %2 of their size</source>
        <translation>%1 flache Teile bekommen eine Dicke vom %2-fachen ihrer Größe</translation>
    </message>
    <message>
        <source>%1 gives way</source>
        <translation>%1 gibt nach</translation>
    </message>
    <message>
        <source>%1 has %2 surfaces, none of which is %3; accepted: %4 to %5</source>
        <translation>%1 hat %2 Flächen, von denen keine %3 ist; erlaubt: %4 bis %5</translation>
    </message>
    <message>
        <source>%1 has 1 surface, none of which is %2; accepted: -1 to 0</source>
        <translation>%1 hat 1 Fläche, die nicht %2 ist; erlaubt: -1 bis 0</translation>
    </message>
    <message>
        <source>%1 has no corners; the file is broken or truncated</source>
        <translation>%1 hat keine Ecken; die Datei ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>%1 has no place: these leave none together: %2; %3 and %4 are %5 m apart at most, %6 m are asked for</source>
        <translation>%1 hat keinen Platz: diese lassen zusammen keinen: %2; %3 und %4 sind höchstens %5 m auseinander, verlangt sind %6 m</translation>
    </message>
    <message>
        <source>%1 has no stable pose</source>
        <translation>%1 hat keine stabile Lage</translation>
    </message>
    <message>
        <source>%1 has no stable pose %2: there are %3, from 0</source>
        <translation>%1 hat keine stabile Lage %2: es gibt %3, ab 0</translation>
    </message>
    <message>
        <source>%1 has no surface to set things down on</source>
        <translation>%1 hat keine Fläche, auf die sich etwas stellen lässt</translation>
    </message>
    <message>
        <source>%1 has vertex %2</source>
        <translation>%1 hat die Ecke %2</translation>
    </message>
    <message>
        <source>%1 have more than %2 entries, the most that fit into the %3 MiB allowed; take fewer pixels or a smaller region</source>
        <translation>%1 haben mehr als %2 Einträge, die höchstens in die erlaubten %3 MiB passen; weniger Pixel oder ein kleineres Gebiet nehmen</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>%1 in reach of %2</source>
        <translation>%1 in Reichweite von %2</translation>
    </message>
    <message>
        <source>%1 in reach of its point</source>
        <translation>%1 in Reichweite von seinem Punkt</translation>
    </message>
    <message>
        <source>%1 in view of %2</source>
        <translation>%1 im Blick von %2</translation>
    </message>
    <message>
        <source>%1 in view of its point</source>
        <translation>%1 im Blick von seinem Punkt</translation>
    </message>
    <message>
        <source>%1 in_front_of %2</source>
        <translation>%1 vor %2</translation>
    </message>
    <message>
        <source>%1 is a software renderer, and those are disabled</source>
        <translation>%1 ist ein Software-Renderer, und die sind abgeschaltet</translation>
    </message>
    <message>
        <source>%1 is already the name of /objects/%2; accepted: a name of its own</source>
        <translation>%1 ist schon der Name von /objects/%2; erlaubt: ein eigener Name</translation>
    </message>
    <message>
        <source>%1 is in the %2</source>
        <translation>%1 ist in der %2</translation>
    </message>
    <message>
        <source>%1 is no object of the scene; accepted: %2</source>
        <translation>%1 ist kein Objekt der Szene; erlaubt: %2</translation>
    </message>
    <message>
        <source>%1 is no regular file</source>
        <translation>%1 ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>%1 is not accepted: a scene keeps its nodes</source>
        <translation>%1 ist nicht erlaubt: eine Szene behält ihre Knoten</translation>
    </message>
    <message>
        <source>%1 is not accepted: what the layout does not pick stays, and what it picks moves unless it says &quot;fixed&quot;</source>
        <translation>%1 ist nicht erlaubt: was das Layout nicht wählt, bleibt, und was es wählt, bewegt sich, wenn es nicht „fixed“ ist</translation>
    </message>
    <message>
        <source>%1 is not accepted; accepted: %2</source>
        <translation>%1 ist nicht erlaubt; erlaubt: %2</translation>
    </message>
    <message>
        <source>%1 is not finite</source>
        <translation>%1 ist nicht endlich</translation>
    </message>
    <message>
        <source>%1 is not used: %2; the backends are measured again</source>
        <translation>%1 wird nicht verwendet: %2; die Backends werden neu gemessen</translation>
    </message>
    <message>
        <source>%1 left_of %2</source>
        <translation>%1 links von %2</translation>
    </message>
    <message>
        <source>%1 m along x</source>
        <translation>%1 m entlang x</translation>
    </message>
    <message>
        <source>%1 m along y</source>
        <translation>%1 m entlang y</translation>
    </message>
    <message>
        <source>%1 makes others give way</source>
        <translation>%1 lässt andere nachgeben</translation>
    </message>
    <message>
        <source>%1 near %2</source>
        <translation>%1 nahe bei %2</translation>
    </message>
    <message>
        <source>%1 need more than the %2 MiB allowed</source>
        <translation>%1 brauchen mehr als die erlaubten %2 MiB</translation>
    </message>
    <message>
        <source>%1 numbers from %2 to %3</source>
        <translation>%1 Zahlen von %2 bis %3</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 auf %2</translation>
    </message>
    <message>
        <source>%1 parallel %2</source>
        <translation>%1 parallel zu %2</translation>
    </message>
    <message>
        <source>%1 perpendicular %2</source>
        <translation>%1 senkrecht zu %2</translation>
    </message>
    <message>
        <source>%1 right_of %2</source>
        <translation>%1 rechts von %2</translation>
    </message>
    <message>
        <source>%1 same %2</source>
        <translation>%1 gedreht wie %2</translation>
    </message>
    <message>
        <source>%1 slides away</source>
        <translation>%1 rutscht weg</translation>
    </message>
    <message>
        <source>%1 symmetric %2</source>
        <translation>%1 symmetrisch zu %2</translation>
    </message>
    <message>
        <source>%1 tips</source>
        <translation>%1 kippt</translation>
    </message>
    <message>
        <source>%1 under %2</source>
        <translation>%1 unter %2</translation>
    </message>
    <message>
        <source>%1 within %2</source>
        <translation>%1 innerhalb von %2</translation>
    </message>
    <message>
        <source>%1 within its region</source>
        <translation>%1 innerhalb seines Gebiets</translation>
    </message>
    <message>
        <source>%1 would have to carry itself: it lies on what it carries</source>
        <translation>%1 müsste sich selbst tragen: es liegt auf dem, was es trägt</translation>
    </message>
    <message>
        <source>%1 would not stand well: it tips, with what lies on it, over an edge %2 m away; accepted: %3 m or more</source>
        <translation>%1 stünde nicht gut: es kippt mit dem, was darauf liegt, über eine Kante, die %2 m entfernt ist; erlaubt: %3 m oder mehr</translation>
    </message>
    <message>
        <source>%1&quot;top&quot;, &quot;bottom&quot;, or a number as trivet info --surfaces has them</source>
        <translation>%1&quot;top&quot;, &quot;bottom&quot;, oder eine Nummer, wie trivet info --surfaces sie zeigt</translation>
    </message>
    <message>
        <source>%1, or an object with friction, density and restitution%2</source>
        <translation>%1, oder ein Objekt mit friction, density und restitution%2</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; cannot be moved: %3</source>
        <translation>%1: „%2“ lässt sich nicht bewegen: %3</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; reaches %3 metres; accepted: up to %4</source>
        <translation>%1: „%2“ reicht bis %3 Meter; erlaubt: bis zu %4</translation>
    </message>
    <message>
        <source>%1: %2 bytes, more than the limit of %3</source>
        <translation>%1: %2 Bytes, mehr als die Grenze von %3</translation>
    </message>
    <message>
        <source>%1: %2 files need %3, which is missing: this build of Trivet lacks Open CASCADE; accepted: a build with it (Debian: libocct-data-exchange-dev libocct-ocaf-dev; TRIVET_OCCT)</source>
        <translation>%1: %2-Dateien brauchen %3, das fehlt: dieses Trivet wurde ohne Open CASCADE gebaut; erlaubt: gebaut mit ihm (Debian: libocct-data-exchange-dev libocct-ocaf-dev; TRIVET_OCCT)</translation>
    </message>
    <message>
        <source>%1: %2 is no object that stands already; accepted for &quot;about&quot;: one that does</source>
        <translation>%1: %2 ist kein Objekt, das schon steht; erlaubt für „about“: eines, das steht</translation>
    </message>
    <message>
        <source>%1: %2 is none of the things to arrange</source>
        <translation>%1: %2 ist keines der Dinge, die anzuordnen sind</translation>
    </message>
    <message>
        <source>%1: %2 says already what carries %3</source>
        <translation>%1: %2 sagt schon, was %3 trägt</translation>
    </message>
    <message>
        <source>%1: %2 since Trivet wrote it; accepted: scenes as Trivet wrote them</source>
        <translation>%1: %2, seit Trivet sie schrieb; erlaubt: Szenen, wie Trivet sie schrieb</translation>
    </message>
    <message>
        <source>%1: %2 stands nowhere and is none of the things to arrange</source>
        <translation>%1: %2 steht nirgends und ist keines der Dinge, die anzuordnen sind</translation>
    </message>
    <message>
        <source>%1: %2; accepted: .glb, .gltf, .obj, .ply and .stl</source>
        <translation>%1: %2; erlaubt: .glb, .gltf, .obj, .ply und .stl</translation>
    </message>
    <message>
        <source>%1: /scene: is not accepted here; accepted: layouts of models. Scenes in place are laid out by trivet run</source>
        <translation>%1: /scene: ist hier nicht erlaubt; erlaubt: Layouts aus Modellen. Szenen an Ort und Stelle legt trivet run aus</translation>
    </message>
    <message>
        <source>%1: MuJoCo does not accept it: %2</source>
        <translation>%1: MuJoCo nimmt es nicht an: %2</translation>
    </message>
    <message>
        <source>%1: a temporary file cannot be written: %2</source>
        <translation>%1: eine vorübergehende Datei lässt sich nicht schreiben: %2</translation>
    </message>
    <message>
        <source>%1: a thing has no relation to itself</source>
        <translation>%1: ein Ding hat keine Relation zu sich selbst</translation>
    </message>
    <message>
        <source>%1: accepted: a box whose upper corner is above its lower one</source>
        <translation>%1: erlaubt: ein Kasten, dessen obere Ecke über der unteren liegt</translation>
    </message>
    <message>
        <source>%1: accepted: at least one</source>
        <translation>%1: erlaubt: mindestens eines</translation>
    </message>
    <message>
        <source>%1: another session has written this journal</source>
        <translation>%1: eine andere Sitzung hat dieses Journal geschrieben</translation>
    </message>
    <message>
        <source>%1: another session is writing this journal</source>
        <translation>%1: eine andere Sitzung schreibt dieses Journal</translation>
    </message>
    <message>
        <source>%1: cannot be awaited</source>
        <translation>%1: lässt sich nicht abwarten</translation>
    </message>
    <message>
        <source>%1: cannot be created: %2</source>
        <translation>%1: lässt sich nicht anlegen: %2</translation>
    </message>
    <message>
        <source>%1: cannot be made: %2</source>
        <translation>%1: lässt sich nicht anlegen: %2</translation>
    </message>
    <message>
        <source>%1: cannot be opened: %2</source>
        <translation>%1: lässt sich nicht öffnen: %2</translation>
    </message>
    <message>
        <source>%1: cannot be opened; accepted: a scene (.glb) written by Trivet, or a layout (.json)</source>
        <translation>%1: lässt sich nicht öffnen; erlaubt: eine Szene (.glb) von Trivet, oder ein Layout (.json)</translation>
    </message>
    <message>
        <source>%1: cannot be read</source>
        <translation>%1: lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>%1: cannot be read: %2</source>
        <translation>%1: lässt sich nicht lesen: %2</translation>
    </message>
    <message>
        <source>%1: cannot be received</source>
        <translation>%1: lässt sich nicht empfangen</translation>
    </message>
    <message>
        <source>%1: cannot be saved; accepted: a file name ending in .glb</source>
        <translation>%1: lässt sich nicht speichern; erlaubt: ein Dateiname auf .glb</translation>
    </message>
    <message>
        <source>%1: cannot be saved; accepted: a file name ending in .glb or .json</source>
        <translation>%1: lässt sich nicht speichern; erlaubt: ein Dateiname auf .glb oder .json</translation>
    </message>
    <message>
        <source>%1: cannot be started</source>
        <translation>%1: lässt sich nicht starten</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2</source>
        <translation>%1: lässt sich nicht schreiben: %2</translation>
    </message>
    <message>
        <source>%1: cannot create a pipe</source>
        <translation>%1: eine Pipe lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>%1: cannot write &quot;%2&quot;; accepted: %3</source>
        <translation>%1: &quot;%2&quot; kann nicht geschrieben werden; erlaubt: %3</translation>
    </message>
    <message>
        <source>%1: convex parts of &quot;%2&quot; and &quot;%3&quot; overlap by %4 metres, %5: a simulator would push them apart; accepted: %6--max-overlap from %7%8</source>
        <translation>%1: konvexe Teile von „%2“ und „%3“ überlappen um %4 Meter, %5: ein Simulator würde sie auseinanderdrücken; erlaubt: %6--max-overlap ab %7%8</translation>
    </message>
    <message>
        <source>%1: exists and does not belong to %2, so it would be overwritten; accepted: another name or folder, or a single-file format, such as .glb</source>
        <translation>%1: gibt es schon und gehört nicht zu %2; es würde überschrieben; erlaubt: ein anderer Name oder Ordner, oder ein Format aus einer Datei, etwa .glb</translation>
    </message>
    <message>
        <source>%1: has %2 triangles, not %3 as Trivet wrote; another program has changed it</source>
        <translation>%1: hat %2 Dreiecke, nicht %3, wie Trivet sie schrieb; ein anderes Programm hat sie geändert</translation>
    </message>
    <message>
        <source>%1: has changed since it was read; accepted: a scene that stays as it is</source>
        <translation>%1: hat sich geändert, seit sie gelesen wurde; erlaubt: eine Szene, die bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>%1: has no extension of a format; accepted: %2</source>
        <translation>%1: hat keine Endung eines Formats; erlaubt: %2</translation>
    </message>
    <message>
        <source>%1: has no mesh for &quot;%2&quot;; another program has changed it</source>
        <translation>%1: hat kein Netz für „%2“; ein anderes Programm hat sie geändert</translation>
    </message>
    <message>
        <source>%1: has no objects: no node of its scene has a mesh</source>
        <translation>%1: hat keine Objekte: kein Knoten ihrer Szene hat ein Netz</translation>
    </message>
    <message>
        <source>%1: is a device or a pipe; accepted: a regular file</source>
        <translation>%1: ist ein Gerät oder eine Pipe; erlaubt: eine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>%1: is a folder, not a file</source>
        <translation>%1: ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>%1: is a pipe that nobody has opened for writing within %2 s; accepted: a file, or a pipe that is fed</source>
        <translation>%1: ist eine Pipe, die niemand innerhalb von %2 s zum Schreiben geöffnet hat; erlaubt: eine Datei, oder eine Pipe, die gespeist wird</translation>
    </message>
    <message>
        <source>%1: is a scene or a model in binary glTF; accepted: JSON, as of a layout</source>
        <translation>%1: ist eine Szene oder ein Modell in binärem glTF; erlaubt: JSON, etwa ein Layout</translation>
    </message>
    <message>
        <source>%1: is an input and would be overwritten; accepted: another name</source>
        <translation>%1: ist eine Eingabe und würde überschrieben; erlaubt: ein anderer Name</translation>
    </message>
    <message>
        <source>%1: is an input, named by %2, and would be overwritten; accepted: another name</source>
        <translation>%1: ist eine Eingabe, genannt von %2, und würde überschrieben; erlaubt: ein anderer Name</translation>
    </message>
    <message>
        <source>%1: is empty; accepted: a JSON object</source>
        <translation>%1: ist leer; erlaubt: ein JSON-Objekt</translation>
    </message>
    <message>
        <source>%1: is larger than the limit of %2 bytes</source>
        <translation>%1: ist größer als die Grenze von %2 Bytes</translation>
    </message>
    <message>
        <source>%1: is missing or empty</source>
        <translation>%1: fehlt oder ist leer</translation>
    </message>
    <message>
        <source>%1: is no journal; accepted: a journal that Trivet wrote</source>
        <translation>%1: ist kein Journal; erlaubt: ein Journal, das Trivet schrieb</translation>
    </message>
    <message>
        <source>%1: is no valid glTF: %2</source>
        <translation>%1: ist kein gültiges glTF: %2</translation>
    </message>
    <message>
        <source>%1: is not glTF, neither binary nor JSON; accepted: .glb and .gltf</source>
        <translation>%1: ist kein glTF, weder binär noch JSON; erlaubt: .glb und .gltf</translation>
    </message>
    <message>
        <source>%1: is not glTF: its JSON has no asset; accepted: a scene, which trivet run makes of a layout</source>
        <translation>%1: ist kein glTF: sein JSON hat kein „asset“; erlaubt: eine Szene, wie trivet run sie aus einem Layout macht</translation>
    </message>
    <message>
        <source>%1: is not valid glTF: %2</source>
        <translation>%1: ist kein gültiges glTF: %2</translation>
    </message>
    <message>
        <source>%1: is open in another editor; close it there first</source>
        <translation>%1: ist in einem anderen Editor offen; zuerst dort schließen</translation>
    </message>
    <message>
        <source>%1: line %2 is damaged, and others follow it; accepted: a journal as Trivet wrote it</source>
        <translation>%1: Zeile %2 ist beschädigt, und andere folgen ihr; erlaubt: ein Journal, wie Trivet es schrieb</translation>
    </message>
    <message>
        <source>%1: needs more memory than the limit of %2 MiB</source>
        <translation>%1: braucht mehr Speicher als die Grenze von %2 MiB</translation>
    </message>
    <message>
        <source>%1: neither &quot;%2&quot; nor &quot;%3&quot; is the file that the session began with; accepted: the same bytes</source>
        <translation>%1: weder „%2“ noch „%3“ ist die Datei, mit der die Sitzung begann; erlaubt: dieselben Bytes</translation>
    </message>
    <message>
        <source>%1: neither is one of the things to arrange</source>
        <translation>%1: keines von beiden ist eines der Dinge, die anzuordnen sind</translation>
    </message>
    <message>
        <source>%1: nested too deep; accepted: up to %2 levels</source>
        <translation>%1: zu tief verschachtelt; erlaubt: bis zu %2 Ebenen</translation>
    </message>
    <message>
        <source>%1: node &apos;%2&apos; refers to mesh %3 of %4</source>
        <translation>%1: Knoten „%2“ verweist auf Netz %3 von %4</translation>
    </message>
    <message>
        <source>%1: the glTF JSON is malformed</source>
        <translation>%1: das glTF-JSON ist fehlerhaft</translation>
    </message>
    <message>
        <source>%1: the scene stays what it is; accepted: %2</source>
        <translation>%1: die Szene behält ihr Format; erlaubt: %2</translation>
    </message>
    <message>
        <source>%1: there is a journal already; accepted: a new name, or restore this one</source>
        <translation>%1: ein Journal gibt es schon; erlaubt: ein neuer Name, oder dieses wiederherstellen</translation>
    </message>
    <message>
        <source>%1: there is no floor</source>
        <translation>%1: es gibt keinen Boden</translation>
    </message>
    <message>
        <source>%1: there is no folder &quot;%2&quot; for the journal</source>
        <translation>%1: den Ordner „%2“ für das Journal gibt es nicht</translation>
    </message>
    <message>
        <source>%1: there is no object %2%3</source>
        <translation>%1: ein Objekt %2 gibt es nicht%3</translation>
    </message>
    <message>
        <source>%1: this key comes twice; accepted: each key once</source>
        <translation>%1: dieser Schlüssel kommt zweimal vor; erlaubt: jeder Schlüssel einmal</translation>
    </message>
    <message>
        <source>%1; BVHs and software answer instead of the GPU</source>
        <translation>%1; BVHs und Software antworten anstelle der GPU</translation>
    </message>
    <message>
        <source>%1; BVHs are used instead of the GPU</source>
        <translation>%1; statt der GPU werden BVHs verwendet</translation>
    </message>
    <message>
        <source>OpenGL was in use when this process was forked</source>
        <translation>OpenGL war in Gebrauch, als dieser Prozess abgespalten wurde</translation>
    </message>
    <message>
        <source>an OpenGL context of the process that this one was forked from</source>
        <translation>ein OpenGL-Kontext des Prozesses, von dem dieser abgespalten wurde</translation>
    </message>
    <message>
        <source>%1; a new OpenGL context goes on</source>
        <translation>%1; ein neuer OpenGL-Kontext macht weiter</translation>
    </message>
    <message>
        <source>%1; auto goes on without %2</source>
        <translation>%1; auto macht ohne %2 weiter</translation>
    </message>
    <message>
        <source>%1; places are judged in software instead</source>
        <translation>%1; stattdessen werden Plätze in Software beurteilt</translation>
    </message>
    <message>
        <source>%1; z-lists in software are used instead of the GPU</source>
        <translation>%1; statt der GPU werden z-Listen in Software verwendet</translation>
    </message>
    <message>
        <source>--collision: &quot;decomposition&quot; is not part of this build (Debian: libbullet-extras-dev); accepted: fitted, hull, components, mesh</source>
        <translation>--collision: „decomposition“ ist nicht Teil dieses Trivet (Debian: libbullet-extras-dev); erlaubt: fitted, hull, components, mesh</translation>
    </message>
    <message>
        <source>--collision: &quot;mesh&quot; is not accepted for MJCF, as MuJoCo takes the hulls of meshes; accepted: fitted, hull, components, decomposition</source>
        <translation>--collision: „mesh“ ist für MJCF nicht erlaubt, da MuJoCo die Hüllen von Netzen nimmt; erlaubt: fitted, hull, components, decomposition</translation>
    </message>
    <message>
        <source>--language %1: accepted: %2</source>
        <translation>--language %1: erlaubt: %2</translation>
    </message>
    <message>
        <source>/arrange/fronts has one for &quot;%1&quot;; accepted: one front for an object</source>
        <translation>/arrange/fronts hat eine für „%1“; erlaubt: eine Vorderseite für ein Objekt</translation>
    </message>
    <message>
        <source>/arrange/surfaces has some for &quot;%1&quot;; accepted: those of an object in one place</source>
        <translation>/arrange/surfaces hat welche für „%1“; erlaubt: die eines Objekts an einer Stelle</translation>
    </message>
    <message>
        <source>0 to %1</source>
        <translation>0 bis %1</translation>
    </message>
    <message>
        <source>1 to %1 letters a to z and A to Z, digits, _ and -, as it becomes a part of file names</source>
        <translation>1 bis %1 Buchstaben a bis z und A bis Z, Ziffern, _ und -, da es Teil von Dateinamen wird</translation>
    </message>
    <message>
        <source>; accepted: fewer --jobs, or a larger ulimit -n</source>
        <translation>; erlaubt: weniger --jobs, oder ein größeres ulimit -n</translation>
    </message>
    <message>
        <source>; did you mean &quot;%1&quot;?</source>
        <translation>; war „%1“ gemeint?</translation>
    </message>
    <message>
        <source>Embree cannot %1 (error %2); it may lack memory</source>
        <translation>Embree kann dies nicht: %1 (Fehler %2); vielleicht fehlt Speicher</translation>
    </message>
    <message>
        <source>Embree cannot start (error %1); it needs a processor with SSE2 and memory</source>
        <translation>Embree kann nicht starten (Fehler %1); es braucht einen Prozessor mit SSE2 und Speicher</translation>
    </message>
    <message>
        <source>GPU method &quot;%1&quot; is not accepted; accepted: auto, framebuffer, compute</source>
        <translation>das GPU-Verfahren „%1“ ist nicht erlaubt; erlaubt: auto, framebuffer, compute</translation>
    </message>
    <message>
        <source>OpenGL failed while %1: %2%3</source>
        <translation>OpenGL ist fehlgeschlagen bei %1: %2%3</translation>
    </message>
    <message>
        <source>TRIVET_EGL_DEVICE is &quot;%1&quot;; accepted: the number of an EGL device, from 1</source>
        <translation>TRIVET_EGL_DEVICE ist „%1“; erlaubt: die Nummer eines EGL-Geräts, ab 1</translation>
    </message>
    <message>
        <source>[0, 0, 0, 1] as fourth row, or none</source>
        <translation>[0, 0, 0, 1] als vierte Zeile, oder keine</translation>
    </message>
    <message>
        <source>[[fx, 0, cx], [0, fy, cy], [0, 0, 1]]</source>
        <translation>[[fx, 0, cx], [0, fy, cy], [0, 0, 1]]</translation>
    </message>
    <message>
        <source>a background component of %1; accepted: 0 to 1</source>
        <translation>ein Farbanteil des Hintergrunds von %1; erlaubt: 0 bis 1</translation>
    </message>
    <message>
        <source>a camera of %1 x %2 pixels for a picture of %3 x %4</source>
        <translation>eine Kamera von %1 x %2 Pixeln für ein Bild von %3 x %4</translation>
    </message>
    <message>
        <source>a chord of %1 is too small for its size; accepted: at least %2</source>
        <translation>eine Sehne von %1 ist zu klein für seine Größe; erlaubt: mindestens %2</translation>
    </message>
    <message>
        <source>a convex part is too small for a solid hull</source>
        <translation>ein konvexer Teil ist zu klein für eine Hülle mit Volumen</translation>
    </message>
    <message>
        <source>a direction whose length is not zero</source>
        <translation>eine Richtung, deren Länge nicht null ist</translation>
    </message>
    <message>
        <source>a dome&apos;s %1 of %2; accepted: %3 to %4</source>
        <translation>eine Kuppel mit %1 %2; erlaubt: %3 bis %4</translation>
    </message>
    <message>
        <source>a file in the folder of the start, or below it</source>
        <translation>eine Datei im Ordner des Anfangs oder darunter</translation>
    </message>
    <message>
        <source>a matrix of %1%2 rows</source>
        <translation>eine Matrix aus %1%2 Zeilen</translation>
    </message>
    <message>
        <source>a mesh of %1 vertices and %2 triangles</source>
        <translation>ein Netz aus %1 Ecken und %2 Dreiecken</translation>
    </message>
    <message>
        <source>a mesh without triangles; accepted: one at least</source>
        <translation>ein Netz ohne Dreiecke; erlaubt: mindestens eines</translation>
    </message>
    <message>
        <source>a node above it has a scale of zero</source>
        <translation>ein Knoten darüber ist mit null skaliert</translation>
    </message>
    <message>
        <source>a node&apos;s %1 has not %2 numbers</source>
        <translation>„%1“ eines Knotens hat nicht %2 Zahlen</translation>
    </message>
    <message>
        <source>a node&apos;s transform is not made of finite numbers</source>
        <translation>die Transformation eines Knotens besteht nicht aus endlichen Zahlen</translation>
    </message>
    <message>
        <source>a picture of %1 samples; accepted: 1 to %2</source>
        <translation>ein Bild mit %1 Proben; erlaubt: 1 bis %2</translation>
    </message>
    <message>
        <source>a picture of %1 x %2 pixels; accepted: 1 to %3 in each dimension</source>
        <translation>ein Bild von %1 x %2 Pixeln; erlaubt: 1 bis %3 in jeder Richtung</translation>
    </message>
    <message>
        <source>a problem of arranging</source>
        <translation>eine Aufgabe des Anordnens</translation>
    </message>
    <message>
        <source>a quaternion [w, x, y, z] of length 1</source>
        <translation>eine Quaternion [w, x, y, z] der Länge 1</translation>
    </message>
    <message>
        <source>a rotation without a position; accepted: both, or neither for an object that is out of the scene until it is put</source>
        <translation>eine Drehung ohne Position; erlaubt: beide, oder keine für ein Objekt, das nicht in der Szene ist, bis es hingestellt wird</translation>
    </message>
    <message>
        <source>a rounded rectangle of %1 segments per corner; accepted: 1 or more</source>
        <translation>ein abgerundetes Rechteck aus %1 Stücken je Ecke; erlaubt: 1 oder mehr</translation>
    </message>
    <message>
        <source>a view of %1 x %2 pixels; accepted: 1 to %3 in each dimension</source>
        <translation>eine Ansicht von %1 x %2 Pixeln; erlaubt: 1 bis %3 in jeder Richtung</translation>
    </message>
    <message>
        <source>a whole number from 0 to 2^53</source>
        <translation>eine ganze Zahl von 0 bis 2^53</translation>
    </message>
    <message>
        <source>accepted: &quot;height&quot; with &quot;b&quot;, a &quot;point&quot; has its own</source>
        <translation>erlaubt: &quot;height&quot; mit &quot;b&quot;, ein &quot;point&quot; hat seine eigene</translation>
    </message>
    <message>
        <source>accepted: either &quot;about&quot; an object, or &quot;point&quot; and &quot;axis&quot;</source>
        <translation>erlaubt: entweder &quot;about&quot; ein Objekt, oder &quot;point&quot; und &quot;axis&quot;</translation>
    </message>
    <message>
        <source>accepted: either &quot;b&quot; or &quot;point&quot;</source>
        <translation>erlaubt: entweder &quot;b&quot; oder &quot;point&quot;</translation>
    </message>
    <message>
        <source>accepted: either &quot;tolerance&quot; or &quot;jitter&quot;, which are one</source>
        <translation>erlaubt: entweder &quot;tolerance&quot; oder &quot;jitter&quot;, die dasselbe sind</translation>
    </message>
    <message>
        <source>accepted: with &quot;margin&quot;, &quot;friction&quot; or both</source>
        <translation>erlaubt: mit &quot;margin&quot;, &quot;friction&quot; oder beidem</translation>
    </message>
    <message>
        <source>an animated WebP has pictures of one size</source>
        <translation>ein animiertes WebP hat Bilder einer Größe</translation>
    </message>
    <message>
        <source>an animated WebP of %1 x %2 pixels is not accepted; accepted: 1 to %3</source>
        <translation>ein animiertes WebP von %1 x %2 Pixeln ist nicht erlaubt; erlaubt: 1 bis %3</translation>
    </message>
    <message>
        <source>an animated WebP: %1</source>
        <translation>ein animiertes WebP: %1</translation>
    </message>
    <message>
        <source>an image cannot be encoded as OpenEXR: %1</source>
        <translation>ein Bild lässt sich nicht als OpenEXR kodieren: %1</translation>
    </message>
    <message>
        <source>an image cannot be encoded as PNG: %1</source>
        <translation>ein Bild lässt sich nicht als PNG kodieren: %1</translation>
    </message>
    <message>
        <source>an object has an empty name; every object needs one</source>
        <translation>ein Objekt hat einen leeren Namen; jedes Objekt braucht einen</translation>
    </message>
    <message>
        <source>at least one camera</source>
        <translation>mindestens eine Kamera</translation>
    </message>
    <message>
        <source>detector &quot;%1&quot; is not accepted; accepted: auto, bvh, software, gpu, framebuffer, compute</source>
        <translation>der Detektor „%1“ ist nicht erlaubt; erlaubt: auto, bvh, software, gpu, framebuffer, compute</translation>
    </message>
    <message>
        <source>below a node that is not scaled evenly it would have shear, which glTF has not</source>
        <translation>unter einem ungleichmäßig skalierten Knoten wäre es geschert, was glTF nicht kennt</translation>
    </message>
    <message>
        <source>brackets of falls need OpenGL 4.3, but %1 has less</source>
        <translation>Schranken von Stürzen brauchen OpenGL 4.3, aber %1 hat weniger</translation>
    </message>
    <message>
        <source>cannot allocate a stream for Qhull&apos;s messages</source>
        <translation>für die Meldungen von Qhull fehlt Speicher</translation>
    </message>
    <message>
        <source>cannot be read as BREP</source>
        <translation>lässt sich nicht als BREP lesen</translation>
    </message>
    <message>
        <source>cannot be read as a model: the PLY header has no end_header</source>
        <translation>lässt sich nicht als Modell lesen: der PLY-Kopf hat kein end_header</translation>
    </message>
    <message>
        <source>cannot draw without a surface (no EGL_KHR_surfaceless_context)</source>
        <translation>ohne Oberfläche lässt sich nicht zeichnen (kein EGL_KHR_surfaceless_context)</translation>
    </message>
    <message>
        <source>cannot make the OpenGL context current on this thread, %1</source>
        <translation>der OpenGL-Kontext lässt sich in diesem Thread nicht verwenden, %1</translation>
    </message>
    <message>
        <source>circle of %1 objects on %2</source>
        <translation>Kreis aus %1 Objekten auf %2</translation>
    </message>
    <message>
        <source>circle of 1 object on %1</source>
        <translation>Kreis aus einem Objekt auf %1</translation>
    </message>
    <message>
        <source>clear of %1</source>
        <translation>frei von %1</translation>
    </message>
    <message>
        <source>clear of %1 by %2 m</source>
        <translation>frei von %1 mit %2 m Abstand</translation>
    </message>
    <message>
        <source>confirmation &quot;%1&quot; is not accepted; accepted: auto, embree, off</source>
        <translation>die Bestätigung „%1“ ist nicht erlaubt; erlaubt: auto, embree, off</translation>
    </message>
    <message>
        <source>direction of z-lists is %1 %2 %3; accepted: finite and not 0 0 0</source>
        <translation>die Richtung von z-Listen ist %1 %2 %3; erlaubt: endlich und nicht 0 0 0</translation>
    </message>
    <message>
        <source>eglInitialize failed, %1</source>
        <translation>eglInitialize ist fehlgeschlagen, %1</translation>
    </message>
    <message>
        <source>facings of %1 objects on %2</source>
        <translation>Frontreihen aus %1 Objekten auf %2</translation>
    </message>
    <message>
        <source>facings of 1 object on %1</source>
        <translation>Frontreihen aus einem Objekt auf %1</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>Blickwinkel</translation>
    </message>
    <message>
        <source>finite coordinates</source>
        <translation>endliche Koordinaten</translation>
    </message>
    <message>
        <source>glTF version %1; accepted: 2</source>
        <translation>glTF Version %1; erlaubt: 2</translation>
    </message>
    <message>
        <source>grid of %1 objects on %2</source>
        <translation>Raster aus %1 Objekten auf %2</translation>
    </message>
    <message>
        <source>grid of 1 object on %1</source>
        <translation>Raster aus einem Objekt auf %1</translation>
    </message>
    <message>
        <source>has %1 x %2 texels; accepted: 1 to %3 each way, at most %4 Mi together</source>
        <translation>hat %1 x %2 Texel; erlaubt: 1 bis %3 in jeder Richtung, zusammen höchstens %4 Mi</translation>
    </message>
    <message>
        <source>has a field of view of %1 degrees; accepted: 1 to 170</source>
        <translation>hat einen Blickwinkel von %1 Grad; erlaubt: 1 bis 170</translation>
    </message>
    <message>
        <source>has its eye at its target; accepted: two different points</source>
        <translation>hat ihr Auge an ihrem Ziel; erlaubt: zwei verschiedene Punkte</translation>
    </message>
    <message>
        <source>has no data of Trivet; accepted: scenes that Trivet wrote</source>
        <translation>hat keine Daten von Trivet; erlaubt: Szenen, die Trivet schrieb</translation>
    </message>
    <message>
        <source>highest elevation</source>
        <translation>größte Höhe</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>in %1</translation>
    </message>
    <message>
        <source>is a CMYK JPEG; accepted: grey and colour</source>
        <translation>ist ein CMYK-JPEG; erlaubt: Grau und Farbe</translation>
    </message>
    <message>
        <source>is an animated WebP; accepted: single pictures</source>
        <translation>ist ein animiertes WebP; erlaubt: einzelne Bilder</translation>
    </message>
    <message>
        <source>is not finite</source>
        <translation>ist nicht endlich</translation>
    </message>
    <message>
        <source>is of the kind %1; accepted: PNG, JPEG, WebP</source>
        <translation>ist von der Art %1; erlaubt: PNG, JPEG, WebP</translation>
    </message>
    <message>
        <source>it has %1 sources; accepted: 1 to 64</source>
        <translation>sie hat %1 Quellen; erlaubt: 1 bis 64</translation>
    </message>
    <message>
        <source>it has more than %1 scans</source>
        <translation>es hat mehr als %1 Durchläufe</translation>
    </message>
    <message>
        <source>it is animated</source>
        <translation>es ist animiert</translation>
    </message>
    <message>
        <source>it is deformed by a skeleton</source>
        <translation>es wird von einem Skelett verformt</translation>
    </message>
    <message>
        <source>it is of another version, build, processor, driver or device</source>
        <translation>sie gehört zu einer anderen Version, einem anderen Prozessor oder Treiber</translation>
    </message>
    <message>
        <source>it would leave no room for %1</source>
        <translation>es ließe keinen Platz für %1</translation>
    </message>
    <message>
        <source>its nodes are no tree</source>
        <translation>ihre Knoten bilden keinen Baum</translation>
    </message>
    <message>
        <source>labelled images of %1 objects; accepted: up to %2</source>
        <translation>Bilder mit Beschriftungen von %1 Objekten; erlaubt: bis zu %2</translation>
    </message>
    <message>
        <source>largest number of entries</source>
        <translation>die größte Zahl der Einträge</translation>
    </message>
    <message>
        <source>latest OpenGL version</source>
        <translation>die neueste OpenGL-Version</translation>
    </message>
    <message>
        <source>left out: ambient and area lights</source>
        <translation>weggelassen: Umgebungs- und Flächenlichter</translation>
    </message>
    <message>
        <source>left out: animations</source>
        <translation>weggelassen: Animationen</translation>
    </message>
    <message>
        <source>left out: it %1</source>
        <translation>weggelassen: sie %1</translation>
    </message>
    <message>
        <source>left out: the texture &quot;%1&quot;, missing, outside the model&apos;s folder, or neither PNG, JPEG nor WebP</source>
        <translation>weggelassen: die Textur „%1“, die fehlt, außerhalb des Modellordners liegt, oder weder PNG, JPEG noch WebP ist</translation>
    </message>
    <message>
        <source>line %1, column %2: %3 is not accepted; accepted: numbers between -1.797e308 and 1.797e308</source>
        <translation>Zeile %1, Spalte %2: %3 ist nicht erlaubt; erlaubt: Zahlen zwischen -1.797e308 und 1.797e308</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>line of %1 objects on %2</source>
        <translation>Linie aus %1 Objekten auf %2</translation>
    </message>
    <message>
        <source>line of 1 object on %1</source>
        <translation>Linie aus einem Objekt auf %1</translation>
    </message>
    <message>
        <source>lines left out</source>
        <translation>weggelassene Linien</translation>
    </message>
    <message>
        <source>lists by &quot;%1&quot; are not accepted; accepted: auto, gpu, software</source>
        <translation>Listen durch „%1“ sind nicht erlaubt; erlaubt: auto, gpu, software</translation>
    </message>
    <message>
        <source>lowest elevation</source>
        <translation>kleinste Höhe</translation>
    </message>
    <message>
        <source>meshes with bones, read in bind pose</source>
        <translation>Netze mit Knochen, in Grundstellung gelesen</translation>
    </message>
    <message>
        <source>mirrored meshes, winding turned round</source>
        <translation>gespiegelte Netze, Umlaufsinn umgekehrt</translation>
    </message>
    <message>
        <source>more than %1</source>
        <translation>mehr als %1</translation>
    </message>
    <message>
        <source>more than %1, and of %2 more pairs</source>
        <translation>mehr als %1, und die %2 weiterer Paare</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which is outside its folder; accepted: files in the folder of the model or below it</source>
        <translation>nennt „%1“, das außerhalb ihres Ordners liegt; erlaubt: Dateien im Ordner des Modells oder darunter</translation>
    </message>
    <message>
        <source>names another file, %1, which is not opened; accepted: one STEP file with all parts</source>
        <translation>nennt eine weitere Datei, %1, die nicht geöffnet wird; erlaubt: eine STEP-Datei mit allen Teilen</translation>
    </message>
    <message>
        <source>no EGL: libEGL.so.1 cannot be loaded (%1); install libegl1</source>
        <translation>kein EGL: libEGL.so.1 lässt sich nicht laden (%1); libegl1 installieren</translation>
    </message>
    <message>
        <source>no OpenGL context: the device is gone</source>
        <translation>kein OpenGL-Kontext: das Gerät ist weg</translation>
    </message>
    <message>
        <source>no OpenGL, %1</source>
        <translation>kein OpenGL, %1</translation>
    </message>
    <message>
        <source>no OpenGL: neither libOpenGL.so.0 nor libGL.so.1 can be loaded; install libopengl0</source>
        <translation>kein OpenGL: weder libOpenGL.so.0 noch libGL.so.1 lässt sich laden; libopengl0 installieren</translation>
    </message>
    <message>
        <source>no arranged demo &apos;%1&apos;; there are %2</source>
        <translation>keine angeordnete Demo „%1“; es gibt %2</translation>
    </message>
    <message>
        <source>no config for OpenGL, %1</source>
        <translation>keine Konfiguration für OpenGL, %1</translation>
    </message>
    <message>
        <source>no context of OpenGL 3.3 core or later, %1</source>
        <translation>kein Kontext von OpenGL 3.3 core oder neuer, %1</translation>
    </message>
    <message>
        <source>no demo &apos;%1&apos;; there are %2</source>
        <translation>keine Demo „%1“; es gibt %2</translation>
    </message>
    <message>
        <source>no memory to encode an image as PNG</source>
        <translation>kein Speicher, um ein Bild als PNG zu kodieren</translation>
    </message>
    <message>
        <source>no model &apos;%1&apos;; there are %2</source>
        <translation>kein Modell „%1“; es gibt %2</translation>
    </message>
    <message>
        <source>no name, or a preset&apos;s with its numbers</source>
        <translation>kein Name, oder der einer Vorgabe mit ihren Zahlen</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>ohne Angabe eines Grundes</translation>
    </message>
    <message>
        <source>no socket for a process: %1%2</source>
        <translation>kein Socket für einen Prozess: %1%2</translation>
    </message>
    <message>
        <source>number of cameras</source>
        <translation>Zahl der Kameras</translation>
    </message>
    <message>
        <source>number of threads of z-lists is %1; accepted: 0 (all) or more</source>
        <translation>die Zahl der Threads von z-Listen ist %1; erlaubt: 0 (alle) oder mehr</translation>
    </message>
    <message>
        <source>object &apos;%1&apos; lies beyond the range of float32, or its pose is not finite; it cannot be exported</source>
        <translation>Objekt „%1“ liegt jenseits des Bereichs von float32, oder seine Lage ist nicht endlich; es lässt sich nicht exportieren</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>auf %1</translation>
    </message>
    <message>
        <source>on %1, level %2</source>
        <translation>auf %1, Ebene %2</translation>
    </message>
    <message>
        <source>one hull for all of its %1 components, more than %2</source>
        <translation>eine Hülle für alle seine %1 Komponenten, mehr als %2</translation>
    </message>
    <message>
        <source>one of %1%2</source>
        <translation>eines von %1%2</translation>
    </message>
    <message>
        <source>out of the %1</source>
        <translation>außerhalb der %1</translation>
    </message>
    <message>
        <source>paths of %1 bounces; accepted: 0 to 64</source>
        <translation>Pfade mit %1 Abprallern; erlaubt: 0 bis 64</translation>
    </message>
    <message>
        <source>points left out</source>
        <translation>weggelassene Punkte</translation>
    </message>
    <message>
        <source>polygons left out, as they could not be triangulated</source>
        <translation>weggelassene Vielecke, die sich nicht in Dreiecke zerlegen ließen</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>region of z-lists has pixels of %1 m; accepted: %2 m or more, for coordinates of this size</source>
        <translation>das Gebiet von z-Listen hat Pixel von %1 m; erlaubt: %2 m oder mehr, bei Koordinaten dieser Größe</translation>
    </message>
    <message>
        <source>region of z-lists is %1 m wide and %2 m high; accepted: above 0</source>
        <translation>das Gebiet von z-Listen ist %1 m breit und %2 m hoch; erlaubt: über 0</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>die Auflösung</translation>
    </message>
    <message>
        <source>resolution of z-lists is %1; accepted: 0 (automatic) to %2</source>
        <translation>die Auflösung von z-Listen ist %1; erlaubt: 0 (selbsttätig) bis %2</translation>
    </message>
    <message>
        <source>resolution of z-lists is %1; accepted: 1 to %2</source>
        <translation>die Auflösung von z-Listen ist %1; erlaubt: 1 bis %2</translation>
    </message>
    <message>
        <source>row of %1 objects on %2</source>
        <translation>Reihe aus %1 Objekten auf %2</translation>
    </message>
    <message>
        <source>row of 1 object on %1</source>
        <translation>Reihe aus einem Objekt auf %1</translation>
    </message>
    <message>
        <source>scenes of other programs cannot be arranged; accepted: objects with models</source>
        <translation>Szenen anderer Programme lassen sich nicht anordnen; erlaubt: Objekte mit Modellen</translation>
    </message>
    <message>
        <source>software renderers are disabled</source>
        <translation>Software-Renderer sind abgeschaltet</translation>
    </message>
    <message>
        <source>the %1 of z-lists is %2; accepted: %3 to %4</source>
        <translation>%1 von z-Listen ist %2; erlaubt: %3 bis %4</translation>
    </message>
    <message>
        <source>the %1 shader of %2 does not compile on this driver: %3</source>
        <translation>der %1-Shader von %2 lässt sich mit diesem Treiber nicht übersetzen: %3</translation>
    </message>
    <message>
        <source>the calibration of the backends cannot be kept: %1</source>
        <translation>die Messung der Backends lässt sich nicht aufheben: %1</translation>
    </message>
    <message>
        <source>the camera %1</source>
        <translation>die Kamera %1</translation>
    </message>
    <message>
        <source>the camera has focal lengths of %1 and %2 pixels; accepted: above 0, below 1e9</source>
        <translation>die Kamera hat Brennweiten von %1 und %2 Pixeln; erlaubt: über 0, unter 1e9</translation>
    </message>
    <message>
        <source>the camera is not finite</source>
        <translation>die Kamera ist nicht endlich</translation>
    </message>
    <message>
        <source>the camera shows %1 metres; accepted: more than 0</source>
        <translation>die Kamera zeigt %1 Meter; erlaubt: mehr als 0</translation>
    </message>
    <message>
        <source>the camera&apos;s orientation is no rotation; accepted: an orthonormal, right-handed matrix to 1e-6</source>
        <translation>die Ausrichtung der Kamera ist keine Drehung; erlaubt: eine orthonormale, rechtshändige Matrix auf 1e-6 genau</translation>
    </message>
    <message>
        <source>the camera&apos;s principal point is %1, %2; accepted: -1e9 to 1e9 pixels</source>
        <translation>der Hauptpunkt der Kamera ist %1, %2; erlaubt: -1e9 bis 1e9 Pixel</translation>
    </message>
    <message>
        <source>the demo &apos;%1&apos; has no model &apos;%2&apos;</source>
        <translation>die Demo „%1“ hat kein Modell „%2“</translation>
    </message>
    <message>
        <source>the driver does not support a framebuffer, status %1</source>
        <translation>der Treiber unterstützt einen Framebuffer nicht, Status %1</translation>
    </message>
    <message>
        <source>the geometry of &quot;%1&quot; was changed</source>
        <translation>die Geometrie von „%1“ wurde geändert</translation>
    </message>
    <message>
        <source>the graphics hardware was reset, %1</source>
        <translation>die Grafikhardware wurde zurückgesetzt, %1</translation>
    </message>
    <message>
        <source>the graphics hardware was reset, injected</source>
        <translation>die Grafikhardware wurde zurückgesetzt, zur Probe</translation>
    </message>
    <message>
        <source>the journal cannot be locked</source>
        <translation>das Journal lässt sich nicht sperren</translation>
    </message>
    <message>
        <source>the journal cannot be opened</source>
        <translation>das Journal lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>the journal cannot be read</source>
        <translation>das Journal lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>the journal cannot be written</source>
        <translation>das Journal lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>the name of one of /objects%1</source>
        <translation>der Name eines von /objects%1</translation>
    </message>
    <message>
        <source>the name of one of /objects, or one with * for any letters%1</source>
        <translation>der Name eines von /objects, oder einer mit * für beliebige Buchstaben%1</translation>
    </message>
    <message>
        <source>the pose of object %1 of the picture is not finite</source>
        <translation>die Lage von Objekt %1 des Bildes ist nicht endlich</translation>
    </message>
    <message>
        <source>the scene names &quot;%1&quot;, which lies outside its folder; accepted: an output in the scene&apos;s own folder</source>
        <translation>die Szene nennt „%1“, das außerhalb ihres Ordners liegt; erlaubt: eine Ausgabe im Ordner der Szene</translation>
    </message>
    <message>
        <source>the scene was moved</source>
        <translation>die Szene wurde bewegt</translation>
    </message>
    <message>
        <source>the shaders of %1 do not link on this driver: %2</source>
        <translation>die Shader von %1 lassen sich mit diesem Treiber nicht binden: %2</translation>
    </message>
    <message>
        <source>there is no section &quot;arrange&quot; for it; accepted: beside such a section</source>
        <translation>es gibt keinen Abschnitt „arrange“ dafür; erlaubt: neben einem solchen Abschnitt</translation>
    </message>
    <message>
        <source>things: %1 carries %2, which is none of the things to arrange</source>
        <translation>Dinge: %1 trägt %2, das keines der Dinge ist, die anzuordnen sind</translation>
    </message>
    <message>
        <source>things: %1 comes twice</source>
        <translation>Dinge: %1 kommt zweimal vor</translation>
    </message>
    <message>
        <source>things: %1 is fixed; accepted: objects that may move</source>
        <translation>Dinge: %1 ist befestigt; erlaubt: Objekte, die sich bewegen dürfen</translation>
    </message>
    <message>
        <source>this build has no &quot;%1&quot;</source>
        <translation>dieses Trivet wurde ohne „%1“ gebaut</translation>
    </message>
    <message>
        <source>this build has no GPU support</source>
        <translation>dieses Trivet wurde ohne GPU-Unterstützung gebaut</translation>
    </message>
    <message>
        <source>this build of trivet writes no OpenEXR (libopenexr-dev was not installed); accepted for depth and normals: .png</source>
        <translation>dieses Trivet schreibt kein OpenEXR (libopenexr-dev war nicht installiert); erlaubt für Tiefe und Normalen: .png</translation>
    </message>
    <message>
        <source>this build of trivet reads no OpenEXR (libopenexr-dev was not installed)</source>
        <translation>dieses Trivet liest kein OpenEXR (libopenexr-dev war nicht installiert)</translation>
    </message>
    <message>
        <source>an image of %1 x %2 pixels; accepted: up to %3 a side, %4 together</source>
        <translation>ein Bild von %1 x %2 Pixeln; erlaubt: bis zu %3 je Seite, %4 zusammen</translation>
    </message>
    <message>
        <source>no OpenEXR image: %1</source>
        <translation>kein OpenEXR-Bild: %1</translation>
    </message>
    <message>
        <source>%1: has scene 999999 already; accepted: another folder</source>
        <translation>%1: hat schon die Szene 999999; erlaubt: ein anderer Ordner</translation>
    </message>
    <message>
        <source>is no list of models; accepted: a set that Trivet wrote, or a new folder</source>
        <translation>ist keine Liste von Modellen; erlaubt: ein Datensatz, den Trivet schrieb, oder ein neuer Ordner</translation>
    </message>
    <message>
        <source>has the key &quot;%1&quot;; accepted: numbers</source>
        <translation>hat den Schlüssel „%1“; erlaubt: Zahlen</translation>
    </message>
    <message>
        <source>is no COCO set that can be added to; accepted: one that Trivet wrote, or a new folder</source>
        <translation>ist kein COCO-Datensatz, der ergänzt werden kann; erlaubt: einer, den Trivet schrieb, oder ein neuer Ordner</translation>
    </message>
    <message>
        <source>an environment of %1 x %2 pixels; accepted: twice as wide as high</source>
        <translation>eine Umgebung von %1 x %2 Pixeln; erlaubt: doppelt so breit wie hoch</translation>
    </message>
    <message>
        <source>an environment that is black</source>
        <translation>eine schwarze Umgebung</translation>
    </message>
    <message>
        <source>the key light has no direction</source>
        <translation>das Hauptlicht hat keine Richtung</translation>
    </message>
    <message>
        <source>a colour of light or floor is out of range; accepted: 0 to 1e6</source>
        <translation>eine Farbe von Licht oder Boden liegt außerhalb des Bereichs; erlaubt: 0 bis 1e6</translation>
    </message>
    <message>
        <source>this server writes no files; it answers with a scene&apos;s bytes</source>
        <translation>dieser Server schreibt keine Dateien; er antwortet mit den Bytes einer Szene</translation>
    </message>
    <message>
        <source>too many zones; accepted: %1</source>
        <translation>zu viele Zonen; erlaubt: %1</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>Dreieck %1</translation>
    </message>
    <message>
        <source>true</source>
        <translation>true</translation>
    </message>
    <message>
        <source>two objects are named &quot;%1&quot;; names must be unique</source>
        <translation>zwei Objekte heißen „%1“; Namen müssen eindeutig sein</translation>
    </message>
    <message>
        <source>up to %1 of each</source>
        <translation>jeweils bis zu %1</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>Ecke %1</translation>
    </message>
    <message>
        <source>vertex %1 %2 is not finite%3</source>
        <translation>Ecke %1 %2 ist nicht endlich%3</translation>
    </message>
    <message>
        <source>vertex %1 %2 lies beyond 1e30%3</source>
        <translation>Ecke %1 %2 liegt jenseits von 1e30%3</translation>
    </message>
    <message>
        <source>whole numbers from 1 to %1</source>
        <translation>ganze Zahlen von 1 bis %1</translation>
    </message>
    <message>
        <source>with this there are more than %1 relations; accepted: fewer</source>
        <translation>damit sind es mehr als %1 Relationen; erlaubt: weniger</translation>
    </message>
    <message>
        <source>z-lists are to be made in software, but by nobody; accepted: software_lists</source>
        <translation>z-Listen sollen in Software entstehen, aber durch niemanden; erlaubt: software_lists</translation>
    </message>
    <message>
        <source>z-lists by compute shaders need OpenGL 4.3, here is %1.%2; accepted: the method framebuffer</source>
        <translation>z-Listen durch Compute-Shader brauchen OpenGL 4.3, hier ist %1.%2; erlaubt: das Verfahren framebuffer</translation>
    </message>
    <message>
        <source>z-lists need %1 KiB of graphics memory, more than the %2 KiB allowed</source>
        <translation>z-Listen brauchen %1 KiB Grafikspeicher, mehr als die erlaubten %2 KiB</translation>
    </message>
    <message>
        <source>zone %1 of %2</source>
        <translation>Zone %1 von %2</translation>
    </message>
    <message>
        <source>zoom levels of z-lists are %1; accepted: 0 to 4</source>
        <translation>die Zoomstufen von z-Listen sind %1; erlaubt: 0 bis 4</translation>
    </message>
    <message>
        <source>its transform flattens it</source>
        <translation>seine Transformation drückt es flach</translation>
    </message>
    <message>
        <source>%1 faces, more than the limit of %2</source>
        <translation>%1 Flächen, mehr als die Grenze von %2</translation>
    </message>
    <message>
        <source>%1: a node&apos;s %2 has not %3 numbers</source>
        <translation>%1: „%2“ eines Knotens hat nicht %3 Zahlen</translation>
    </message>
    <message>
        <source>%1: has the type %2; accepted: %3</source>
        <translation>%1: hat den Typ %2; erlaubt: %3</translation>
    </message>
    <message>
        <source>%1: is UTF-16 text; accepted: glTF in UTF-8</source>
        <translation>%1: ist Text in UTF-16; erlaubt: glTF in UTF-8</translation>
    </message>
    <message>
        <source>a buffer view is compressed by meshoptimizer, which this build lacks; accepted: files without EXT_meshopt_compression</source>
        <translation>ein Puffer-Ausschnitt ist mit meshoptimizer komprimiert, das dieser Build nicht hat; erlaubt: Dateien ohne EXT_meshopt_compression</translation>
    </message>
    <message>
        <source>a primitive has the mode %1; accepted: 0 to 6</source>
        <translation>ein Primitiv hat den Modus %1; erlaubt: 0 bis 6</translation>
    </message>
    <message>
        <source>an accessor has %1 items and no data; accepted: up to %2</source>
        <translation>ein Accessor hat %1 Einträge und keine Daten; erlaubt: bis zu %2</translation>
    </message>
    <message>
        <source>array</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>has no scene; accepted: one at least</source>
        <translation>hat keine Szene; erlaubt: mindestens eines</translation>
    </message>
    <message>
        <source>has the filter %1; accepted: NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL and COLOR</source>
        <translation>hat den Filter %1; erlaubt: NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL und COLOR</translation>
    </message>
    <message>
        <source>indices have the component type %1; accepted: 5121, 5123 and 5125</source>
        <translation>Indizes haben den Komponententyp %1; erlaubt: 5121, 5123 und 5125</translation>
    </message>
    <message>
        <source>is not valid glTF: %1</source>
        <translation>ist kein gültiges glTF: %1</translation>
    </message>
    <message>
        <source>it is compressed by Draco, which this build lacks; accepted: files without KHR_draco_mesh_compression</source>
        <translation>es ist mit Draco komprimiert, das dieser Build nicht hat; erlaubt: Dateien ohne KHR_draco_mesh_compression</translation>
    </message>
    <message>
        <source>its Draco data is damaged: a face without a point</source>
        <translation>seine Draco-Daten sind beschädigt: eine Fläche ohne Punkt</translation>
    </message>
    <message>
        <source>its Draco data is damaged: a point without a value</source>
        <translation>seine Draco-Daten sind beschädigt: ein Punkt ohne Wert</translation>
    </message>
    <message>
        <source>mesh &apos;%1&apos;: %2</source>
        <translation>Netz „%1“: %2</translation>
    </message>
    <message>
        <source>meshes with morph targets, read without them</source>
        <translation>Netze mit Morph-Zielen, ohne diese gelesen</translation>
    </message>
    <message>
        <source>normals left out, as they are not one to each vertex</source>
        <translation>weggelassene Normalen, die nicht eine für jede Ecke sind</translation>
    </message>
    <message>
        <source>object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>primitives left out, as they have no positions</source>
        <translation>weggelassene Primitive, die keine Positionen haben</translation>
    </message>
    <message>
        <source>requires %1, which Trivet does not have; accepted: files that do without</source>
        <translation>verlangt %1, was Trivet nicht hat; erlaubt: Dateien, die ohne das auskommen</translation>
    </message>
    <message>
        <source>vertices left out, too few for another triangle</source>
        <translation>weggelassene Ecken, zu wenige für ein weiteres Dreieck</translation>
    </message>
    <message>
        <source>the unit of the file is out of range, and left out</source>
        <translation>die Einheit der Datei liegt außerhalb des Bereichs und bleibt weg</translation>
    </message>
    <message>
        <source>coordinates are read as float32, so far from the origin in steps of up to %1: digits of the file may be lost</source>
        <translation>Koordinaten werden als float32 gelesen, so weit vom Ursprung in Schritten bis %1: Ziffern der Datei können verloren sein</translation>
    </message>
    <message>
        <source>polygons that cross themselves, read as fans</source>
        <translation>Vielecke, die sich selbst schneiden, als Fächer gelesen</translation>
    </message>
    <message>
        <source>is packed by gzip; accepted: the unpacked file</source>
        <translation>ist mit gzip gepackt; erlaubt: die ausgepackte Datei</translation>
    </message>
    <message>
        <source>is a picture or a page, not a model</source>
        <translation>ist ein Bild oder eine Seite, kein Modell</translation>
    </message>
    <message>
        <source>its unit is not above 0 metres</source>
        <translation>seine Einheit ist nicht größer als 0 Meter</translation>
    </message>
    <message>
        <source>is a packed file; accepted: the unpacked model</source>
        <translation>ist eine gepackte Datei; erlaubt: das ausgepackte Modell</translation>
    </message>
    <message>
        <source>left out: the material file &quot;%1&quot;, which is missing</source>
        <translation>weggelassen: die Materialdatei „%1“, die fehlt</translation>
    </message>
    <message>
        <source>left out: lines of the .mtl file: %1</source>
        <translation>weggelassen: Zeilen der .mtl-Datei: %1</translation>
    </message>
    <message>
        <source>left out: colours of the .mtl file by &quot;%1&quot;</source>
        <translation>weggelassen: Farben der .mtl-Datei durch „%1“</translation>
    </message>
    <message>
        <source>maps of ambient colour</source>
        <translation>Texturen der Umgebungsfarbe</translation>
    </message>
    <message>
        <source>maps of gloss</source>
        <translation>Texturen des Glanzes</translation>
    </message>
    <message>
        <source>displacement maps</source>
        <translation>Verschiebungstexturen</translation>
    </message>
    <message>
        <source>decals</source>
        <translation>Abziehbilder</translation>
    </message>
    <message>
        <source>reflection maps</source>
        <translation>Spiegelungstexturen</translation>
    </message>
    <message>
        <source>line %1, &quot;%2&quot;</source>
        <translation>Zeile %1, „%2“</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>a vertex of %1 numbers; accepted: 3 at least</source>
        <translation>eine Ecke mit %1 Zahlen; erlaubt: mindestens 3</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>too many vertices</source>
        <translation>zu viele Ecken</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a corner of a face; accepted: 7, 7/1, 7//3, 7/1/3</source>
        <translation>„%1“ ist keine Ecke einer Fläche; erlaubt: 7, 7/1, 7//3, 7/1/3</translation>
    </message>
    <message>
        <source>a face refers to vertex %1, which is out of range; accepted: 1 to %2, and -1 to -%3 from the last one back</source>
        <translation>eine Fläche verweist auf Ecke %1, die es nicht gibt; erlaubt: 1 bis %2, und -1 bis -%3 von der letzten zurück</translation>
    </message>
    <message>
        <source>left out: the material &quot;%1&quot;, which no .mtl file has</source>
        <translation>weggelassen: das Material „%1“, das keine .mtl-Datei hat</translation>
    </message>
    <message>
        <source>materials left out beside it</source>
        <translation>außerdem weggelassene Materialien</translation>
    </message>
    <message>
        <source>curves and free-form surfaces left out</source>
        <translation>weggelassene Kurven und Freiformflächen</translation>
    </message>
    <message>
        <source>commands to other programs left out</source>
        <translation>weggelassene Befehle an andere Programme</translation>
    </message>
    <message>
        <source>weights of vertices left out</source>
        <translation>weggelassene Gewichte von Ecken</translation>
    </message>
    <message>
        <source>texture coordinates and normals left out that cannot be read</source>
        <translation>weggelassene unlesbare Texturkoordinaten und Normalen</translation>
    </message>
    <message>
        <source>texture coordinates and normals of corners left out that are not there</source>
        <translation>weggelassene Texturkoordinaten und Normalen von Ecken, die es nicht gibt</translation>
    </message>
    <message>
        <source>lines of unknown kinds left out, the first %1</source>
        <translation>weggelassene Zeilen unbekannter Art, die erste: %1</translation>
    </message>
    <message>
        <source>cannot be read as a model: it does not begin with &quot;ply&quot;</source>
        <translation>lässt sich nicht als Modell lesen: es beginnt nicht mit „ply“</translation>
    </message>
    <message>
        <source>the format &quot;%1&quot;; accepted: ascii, binary_little_endian, binary_big_endian</source>
        <translation>das Format „%1“; erlaubt: ascii, binary_little_endian, binary_big_endian</translation>
    </message>
    <message>
        <source>an element without its number</source>
        <translation>ein Element ohne seine Anzahl</translation>
    </message>
    <message>
        <source>a property before the first element</source>
        <translation>eine Eigenschaft vor dem ersten Element</translation>
    </message>
    <message>
        <source>the type &quot;%1&quot;; accepted: char, uchar, short, ushort, int, uint, float, double</source>
        <translation>der Typ „%1“; erlaubt: char, uchar, short, ushort, int, uint, float, double</translation>
    </message>
    <message>
        <source>elements &quot;%1&quot; left out: %2</source>
        <translation>weggelassene Elemente „%1“: %2</translation>
    </message>
    <message>
        <source>left out: textures without coordinates</source>
        <translation>weggelassen: Texturen ohne Koordinaten</translation>
    </message>
    <message>
        <source>bytes behind the data left out</source>
        <translation>weggelassene Bytes hinter den Daten</translation>
    </message>
    <message>
        <source>left out: numbers in lines of which the header says nothing</source>
        <translation>weggelassen: Zahlen in Zeilen, von denen der Kopf nichts sagt</translation>
    </message>
    <message>
        <source>is truncated: %1 of %2 elements of PLY data</source>
        <translation>ist abgeschnitten: %1 von %2 Elementen der PLY-Daten</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number, in line %2 of the PLY data</source>
        <translation>„%1“ ist keine Zahl, in Zeile %2 der PLY-Daten</translation>
    </message>
    <message>
        <source>the reader for %1 stopped with %2: a fault of the reader, or it needs more memory than the limit of %3 MiB</source>
        <translation>das Leseprogramm für %1 brach ab mit %2: ein Fehler des Leseprogramms, oder es braucht mehr Speicher als die Grenze von %3 MiB</translation>
    </message>
    <message>
        <source>this file</source>
        <translation>diese Datei</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1-Dateien</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>places of nodes are read as float32: digits are lost, up to %1</source>
        <translation>Orte von Knoten sind als float32 gelesen: Stellen gehen verloren, bis zu %1</translation>
    </message>
    <message>
        <source>is truncated: %1 of %2 vertices and faces of OFF</source>
        <translation>ist abgeschnitten: %1 von %2 Ecken und Flächen von OFF</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number of vertices, faces or corners</source>
        <translation>„%1“ ist keine Zahl von Ecken oder Flächen</translation>
    </message>
    <message>
        <source>is binary OFF; accepted: OFF as text</source>
        <translation>ist binäres OFF; erlaubt: OFF als Text</translation>
    </message>
    <message>
        <source>a face refers to vertex %1, which is out of range; accepted: 0 to %2</source>
        <translation>eine Fläche verweist auf Ecke %1, die es nicht gibt; erlaubt: 0 bis %2</translation>
    </message>
    <message>
        <source>colours of faces left out, numbers of a table</source>
        <translation>weggelassene Farben von Flächen, Nummern einer Tabelle</translation>
    </message>
    <message>
        <source>triangles of the file left out by its reader</source>
        <translation>Dreiecke der Datei, die ihr Leser weggelassen hat</translation>
    </message>
    <message>
        <source>words behind the faces left out</source>
        <translation>weggelassene Wörter hinter den Flächen</translation>
    </message>
    <message>
        <source>the unit that was given is left out: curved models come in metres</source>
        <translation>die angegebene Einheit ist weggelassen: gekrümmte Modelle kommen in Metern</translation>
    </message>
    <message>
        <source>lies far from the file&apos;s origin; is read about an origin of its own, at (%1, %2, %3) of the file</source>
        <translation>liegt weit vom Ursprung der Datei; ist um einen eigenen Ursprung gelesen, bei (%1, %2, %3) der Datei</translation>
    </message>
    <message>
        <source>bytes behind the triangles left out</source>
        <translation>weggelassene Bytes hinter den Dreiecken</translation>
    </message>
    <message>
        <source>the number of triangles is not stated; by the size of the file: %1</source>
        <translation>die Zahl der Dreiecke ist nicht angegeben; nach der Größe der Datei: %1</translation>
    </message>
    <message>
        <source>is truncated: %1 of %2 triangles of a binary STL</source>
        <translation>ist abgeschnitten: %1 von %2 Dreiecken eines binären STL</translation>
    </message>
    <message>
        <source>facets of other than three or more vertices left out</source>
        <translation>weggelassene Facetten mit weniger als drei Ecken</translation>
    </message>
    <message>
        <source>facets without their end left out</source>
        <translation>weggelassene Facetten ohne ihr Ende</translation>
    </message>
    <message>
        <source>unknown words left out</source>
        <translation>weggelassene unbekannte Wörter</translation>
    </message>
    <message>
        <source>is truncated within a vertex</source>
        <translation>ist in einer Ecke abgeschnitten</translation>
    </message>
    <message>
        <source>cannot be read as a model: neither text nor a binary STL, which has 84 bytes at least</source>
        <translation>lässt sich nicht als Modell lesen: weder Text noch ein binäres STL, das mindestens 84 Bytes hat</translation>
    </message>
    <message>
        <source>face %1 refers to vertex %2 of %3</source>
        <translation>Fläche %1 verweist auf Ecke %2 von %3</translation>
    </message>
    <message>
        <source>vertex %1 %2 lies beyond 1e30</source>
        <translation>Ecke %1 %2 liegt jenseits von 1e30</translation>
    </message>
    <message>
        <source>vertex %1 %2 is not finite</source>
        <translation>Ecke %1 %2 ist nicht endlich</translation>
    </message>
    <message>
        <source>triangles whose corners have different colours, of which the first is taken</source>
        <translation>Dreiecke mit verschiedenfarbigen Ecken, von denen die erste gilt</translation>
    </message>
    <message>
        <source>properties of triangles left out that are neither materials nor colours</source>
        <translation>weggelassene Eigenschaften von Dreiecken, die weder Materialien noch Farben sind</translation>
    </message>
    <message>
        <source>textures and mixed materials</source>
        <translation>Texturen und gemischte Materialien</translation>
    </message>
    <message>
        <source>slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>lattices of beams</source>
        <translation>Gitter aus Stäben</translation>
    </message>
    <message>
        <source>requires the extension &quot;%1&quot;; accepted: production, materials, slices</source>
        <translation>verlangt die Erweiterung „%1“; erlaubt: Produktion, Materialien, Schichten</translation>
    </message>
    <message>
        <source>the unit &quot;%1&quot; is unknown; millimetres are taken</source>
        <translation>die Einheit „%1“ ist unbekannt; Millimeter werden angenommen</translation>
    </message>
    <message>
        <source>an element &quot;%1&quot; without its %2</source>
        <translation>ein Element „%1“ ohne sein %2</translation>
    </message>
    <message>
        <source>a reference to %1 %2 of %3</source>
        <translation>ein Verweis auf %1 %2 von %3</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>a transform that is not 12 numbers: &quot;%1&quot;</source>
        <translation>eine Transformation, die nicht aus 12 Zahlen besteht: „%1“</translation>
    </message>
    <message>
        <source>is a ZIP archive without a model of 3MF</source>
        <translation>ist ein ZIP-Archiv ohne Modell von 3MF</translation>
    </message>
    <message>
        <source>items read that are marked as not to be printed</source>
        <translation>gelesene Teile, die nicht gedruckt werden sollen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot come into a scene of another program</source>
        <translation>„%1“ kann in keine Szene eines anderen Programms kommen</translation>
    </message>
    <message>
        <source>&quot;to&quot; or &quot;by&quot;</source>
        <translation>„to“ oder „by“</translation>
    </message>
    <message>
        <source>a number, &quot;lower&quot;, &quot;upper&quot;</source>
        <translation>eine Zahl, „lower“, „upper“</translation>
    </message>
    <message>
        <source>an operation or several, or &quot;poses&quot;</source>
        <translation>eine oder mehrere Operationen, oder „poses“</translation>
    </message>
    <message>
        <source>cannot be saved; accepted: a file name ending in %1, as the scene&apos;s</source>
        <translation>kann nicht gespeichert werden; erlaubt: ein Dateiname, der auf %1 endet wie der der Szene</translation>
    </message>
    <message>
        <source>heights count from the floor, which is at %1 m in the file</source>
        <translation>Höhen zählen ab dem Boden, der in der Datei bei %1 m liegt</translation>
    </message>
    <message>
        <source>not read: %1</source>
        <translation>nicht gelesen: %1</translation>
    </message>
    <message>
        <source>operations that move objects: a scene of another program keeps its objects</source>
        <translation>Operationen, die Objekte bewegen: eine Szene eines anderen Programms behält ihre Objekte</translation>
    </message>
    <message>
        <source>supports for printing left out</source>
        <translation>weggelassene Druckstützen</translation>
    </message>
    <message>
        <source>refers to the object %1 of &quot;%2&quot;, which is not there</source>
        <translation>verweist auf das Objekt %1 von „%2“, das es nicht gibt</translation>
    </message>
    <message>
        <source>its components are nested too deeply, or too many</source>
        <translation>ihre Bestandteile sind zu tief verschachtelt oder zu viele</translation>
    </message>
    <message>
        <source>more faces than the limit of %1</source>
        <translation>mehr Flächen als die Grenze von %1</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>is a damaged ZIP archive: %1</source>
        <translation>ist ein beschädigtes ZIP-Archiv: %1</translation>
    </message>
    <message>
        <source>has more than %1 bytes unpacked</source>
        <translation>hat ausgepackt mehr als %1 Bytes</translation>
    </message>
    <message>
        <source>closed parts inside out, or cavities wound as solids, turned round for mass</source>
        <translation>geschlossene Teile mit der Innenseite außen, oder Hohlräume wie Körper, für die Masse umgekehrt</translation>
    </message>
    <message>
        <source>faces of closed parts wound the other way than most, turned round for mass</source>
        <translation>Flächen geschlossener Teile mit anderem Umlaufsinn als die meisten, für die Masse umgekehrt</translation>
    </message>
    <message>
        <source>copies of faces and walls between parts, left out for mass</source>
        <translation>Kopien von Flächen und Wände zwischen Teilen, für die Masse weggelassen</translation>
    </message>
    <message>
        <source>open parts without an inside, which weigh nothing</source>
        <translation>offene Teile ohne Inneres, die nichts wiegen</translation>
    </message>
    <message>
        <source>open parts without an inside: mass by the surface of all parts</source>
        <translation>offene Teile ohne Inneres: Masse nach der Oberfläche aller Teile</translation>
    </message>
    <message>
        <source>mass by %1 would have its centre farther away by %2 in units of the file</source>
        <translation>nach %1 läge der Schwerpunkt um %2 Einheiten der Datei entfernt</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>der Oberfläche</translation>
    </message>
    <message>
        <source>volume of the closed parts</source>
        <translation>dem Volumen der geschlossenen Teile</translation>
    </message>
    <message>
        <source>%1 touches %2, and there is no room to move it apart</source>
        <translation>%1 berührt %2, und für einen Abstand ist kein Platz</translation>
    </message>
    <message>
        <source>%1, by %2 m near (%3, %4, %5)</source>
        <translation>%1, um %2 m nahe (%3, %4, %5)</translation>
    </message>
    <message>
        <source>a value is missing, or of another kind</source>
        <translation>ein Wert fehlt oder ist von anderer Art</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>eine ganze Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>unknown key; accepted: %1%2%3</source>
        <translation>unbekannter Schlüssel; erlaubt: %1%2%3</translation>
    </message>
    <message>
        <source>1 where a place is searched for</source>
        <translation>1, wo ein Platz gesucht wird</translation>
    </message>
    <message>
        <source>%1: %2 is not accepted; accepted: %3</source>
        <translation>%1: %2 ist nicht erlaubt; erlaubt: %3</translation>
    </message>
    <message>
        <source>the text is too long; accepted: up to %1 bytes</source>
        <translation>der Text ist zu lang; erlaubt: bis zu %1 Bytes</translation>
    </message>
    <message>
        <source>the session has %1 objects, and %2 more are too many; accepted: up to %3</source>
        <translation>die Sitzung hat %1 Objekte, und %2 weitere sind zu viele; erlaubt: bis zu %3</translation>
    </message>
    <message>
        <source>%1: is there already, and would be replaced by the journal&apos;s copy of &quot;%2&quot;; accepted: another name of the journal</source>
        <translation>%1: ist schon da und würde durch die Kopie des Journals von „%2“ ersetzt; erlaubt: ein anderer Name des Journals</translation>
    </message>
    <message>
        <source>%1: has changed while it was opened; open it again</source>
        <translation>%1: hat sich geändert, während es geöffnet wurde; öffnen Sie es noch einmal</translation>
    </message>
    <message>
        <source>%1: the journal was deleted, and no further step is done; save the scene</source>
        <translation>%1: das Journal wurde gelöscht, und kein weiterer Schritt wird getan; speichern Sie die Szene</translation>
    </message>
    <message>
        <source>%1: another program has changed the journal, and no further step is done; save the scene</source>
        <translation>%1: ein anderes Programm hat das Journal geändert, und kein weiterer Schritt wird getan; speichern Sie die Szene</translation>
    </message>
    <message>
        <source>a position and a rotation w, x, y, z</source>
        <translation>eine Position und eine Drehung w, x, y, z</translation>
    </message>
    <message>
        <source>its lower corner, then its upper one</source>
        <translation>seine untere Ecke, dann seine obere</translation>
    </message>
    <message>
        <source>an object of poses</source>
        <translation>ein Objekt mit Lagen</translation>
    </message>
    <message>
        <source>1 and %1, the versions of journals</source>
        <translation>1 und %1, die Versionen von Journalen</translation>
    </message>
    <message>
        <source>has changed since the session</source>
        <translation>hat sich seit der Sitzung geändert</translation>
    </message>
    <message>
        <source>cannot be read, and a box of its size stands in for it: %1</source>
        <translation>lässt sich nicht lesen, und ein Quader seiner Größe steht dafür: %1</translation>
    </message>
    <message>
        <source>poses of &quot;%1&quot; are as they were recorded: %2</source>
        <translation>Lagen aus „%1“ sind so, wie sie aufgezeichnet wurden: %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>%1 or a point [x, y]</source>
        <translation>%1 oder ein Punkt [x, y]</translation>
    </message>
    <message>
        <source>; %1 goes with %2%3</source>
        <translation>; %1 gehört zu %2%3</translation>
    </message>
    <message>
        <source>a target is missing; accepted: &quot;to&quot;, or &quot;direction&quot; and &quot;distance&quot;</source>
        <translation>ein Ziel fehlt; erlaubt: &quot;to&quot;, oder &quot;direction&quot; und &quot;distance&quot;</translation>
    </message>
    <message>
        <source>a place is missing; accepted: &quot;position&quot;, from where it falls, or &quot;on&quot;, an object or &quot;floor&quot;, on which a place is found</source>
        <translation>ein Ort fehlt; erlaubt: &quot;position&quot;, von wo es fällt, oder &quot;on&quot;, ein Objekt oder &quot;floor&quot;, worauf ein Platz gefunden wird</translation>
    </message>
    <message>
        <source>at least 3 corners [x, y] of a convex polygon, counter-clockwise</source>
        <translation>mindestens 3 Ecken [x, y] eines konvexen Vielecks, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>&quot;%1&quot; came to rest as it is: here it is fixed and does not bend</source>
        <translation>„%1“ ist so zur Ruhe gekommen: hier steht es fest und biegt sich nicht</translation>
    </message>
    <message>
        <source>%1 cannot be draped: %2</source>
        <translation>%1 lässt sich nicht drapieren: %2</translation>
    </message>
    <message>
        <source>%1 did not come to rest within %2 steps: near (%3, %4, %5) a force of %6 times the weight of a vertex is left</source>
        <translation>%1 kam in %2 Schritten nicht zur Ruhe: nahe (%3, %4, %5) bleibt eine Kraft vom %6-fachen des Gewichts einer Ecke</translation>
    </message>
    <message>
        <source>%1 would be stretched by a factor of %2; accepted: up to %3. Its pins are too far apart, or it is too weak</source>
        <translation>%1 würde um den Faktor %2 gedehnt; zulässig: bis %3. Seine Nadeln stecken zu weit auseinander, oder es ist zu schwach</translation>
    </message>
    <message>
        <source>%1 would pass through itself</source>
        <translation>%1 würde sich selbst durchdringen</translation>
    </message>
    <message>
        <source>at its start %1 passes through itself</source>
        <translation>%1 durchdringt sich am Anfang selbst</translation>
    </message>
    <message>
        <source>drape</source>
        <translation>drapieren</translation>
    </message>
    <message>
        <source>has ids beyond those of %1 vertices</source>
        <translation>hat Nummern jenseits derer von %1 Ecken</translation>
    </message>
    <message>
        <source>is no array of %1 finite items</source>
        <translation>ist kein Feld aus %1 endlichen Elementen</translation>
    </message>
    <message>
        <source>its mesh has %1 vertices; accepted: up to %2</source>
        <translation>sein Netz hat %1 Ecken; zulässig: bis %2</translation>
    </message>
    <message>
        <source>its mesh has triangles without area</source>
        <translation>sein Netz hat Dreiecke ohne Fläche</translation>
    </message>
    <message>
        <source>the cells of its mesh are %1 m wide; accepted: %2 m or more, twice the thickness</source>
        <translation>die Zellen seines Netzes sind %1 m breit; zulässig: ab %2 m, der doppelten Dicke</translation>
    </message>
    <message>
        <source>its mesh is closed; accepted: open ones</source>
        <translation>sein Netz ist geschlossen; zulässig: offene</translation>
    </message>
    <message>
        <source>its mesh is no surface of one side: an edge has two faces in one direction</source>
        <translation>sein Netz ist keine Fläche mit einheitlicher Seite: eine Kante hat zwei Dreiecke in einer Richtung</translation>
    </message>
    <message>
        <source>lengths that give at most %1 cells</source>
        <translation>Längen, die höchstens %1 Zellen ergeben</translation>
    </message>
    <message>
        <source>two or more, over a millimetre or more</source>
        <translation>zwei oder mehr, über einen Millimeter oder mehr</translation>
    </message>
    <message>
        <source>cells along both sides that fit the vertices, and their lengths</source>
        <translation>Zellen entlang beider Seiten, die zu den Ecken passen, und deren Längen</translation>
    </message>
    <message>
        <source>cells of %1 m or more, twice the thickness</source>
        <translation>Zellen von %1 m oder mehr, der doppelten Dicke</translation>
    </message>
    <message>
        <source>has a face with two equal corners</source>
        <translation>hat ein Dreieck mit zwei gleichen Ecken</translation>
    </message>
    <message>
        <source>%1: a node&apos;s matrix has not 0 0 0 1 as its last row</source>
        <translation>%1: die Matrix eines Knotens hat als letzte Zeile nicht 0 0 0 1</translation>
    </message>
    <message>
        <source>%1: a node&apos;s rotation has no length; accepted: a quaternion of length 1</source>
        <translation>%1: die Drehung eines Knotens hat keine Länge; erlaubt: ein Quaternion der Länge 1</translation>
    </message>
    <message>
        <source>a data URI has no comma before its data</source>
        <translation>in einer Daten-URI fehlt das Komma vor den Daten</translation>
    </message>
    <message>
        <source>hidden nodes, read like all others</source>
        <translation>verborgene Knoten, gelesen wie alle anderen</translation>
    </message>
    <message>
        <source>is a CAD file under another name; accepted: a name in .step, .iges or .brep</source>
        <translation>ist eine CAD-Datei unter einem anderen Namen; erlaubt: ein Name auf .step, .iges oder .brep</translation>
    </message>
    <message>
        <source>is a pointer of Git LFS, not the file itself; accepted: the file that it stands for (git lfs pull)</source>
        <translation>ist ein Verweis von Git LFS, nicht die Datei selbst; erlaubt: die Datei, für die er steht (git lfs pull)</translation>
    </message>
    <message>
        <source>is a web page; accepted: the file that the page offers</source>
        <translation>ist eine Webseite; erlaubt: die Datei, die die Seite anbietet</translation>
    </message>
    <message>
        <source>is nOFF with vertices of %1 numbers; accepted: 3</source>
        <translation>ist nOFF mit Ecken aus %1 Zahlen; erlaubt: 3</translation>
    </message>
    <message>
        <source>left out: the material file &quot;%1&quot;, which %2</source>
        <translation>weggelassen: die Materialdatei „%1“; sie %2</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which %2</source>
        <translation>nennt „%1“; diese Datei %2</translation>
    </message>
    <message>
        <source>rotations of nodes brought to length 1: %1</source>
        <translation>auf die Länge 1 gebrachte Drehungen von Knoten: %1</translation>
    </message>
    <message>
        <source>rotations whose length is not 1</source>
        <translation>Drehungen, deren Länge nicht 1 ist</translation>
    </message>
    <message>
        <source>the keyword &quot;%1&quot;; accepted: OFF, with ST, C, N, 4 and n before it</source>
        <translation>das Schlüsselwort „%1“; erlaubt: OFF, mit ST, C, N, 4 und n davor</translation>
    </message>
    <message>
        <source>NURBS left out</source>
        <translation>weggelassene NURBS</translation>
    </message>
    <message>
        <source>convex hulls left out</source>
        <translation>weggelassene konvexe Hüllen</translation>
    </message>
    <message>
        <source>curved solids left out</source>
        <translation>weggelassene gekrümmte Körper</translation>
    </message>
    <message>
        <source>figures left out</source>
        <translation>weggelassene Figuren</translation>
    </message>
    <message>
        <source>instances of prototypes left out</source>
        <translation>weggelassene Instanzen von Prototypen</translation>
    </message>
    <message>
        <source>last rows of matrices that are not 0 0 0 1, left out</source>
        <translation>weggelassene letzte Zeilen von Matrizen, die nicht 0 0 0 1 sind</translation>
    </message>
    <message>
        <source>levels of detail left out</source>
        <translation>weggelassene Detailstufen</translation>
    </message>
    <message>
        <source>references to geometry that is not there, left out</source>
        <translation>weggelassene Verweise auf fehlende Geometrie</translation>
    </message>
    <message>
        <source>splines left out</source>
        <translation>weggelassene Splines</translation>
    </message>
    <message>
        <source>texts left out</source>
        <translation>weggelassene Texte</translation>
    </message>
    <message>
        <source>a stride of %1 bytes is less than an item of %2</source>
        <translation>ein Abstand von %1 Bytes ist kleiner als ein Eintrag von %2</translation>
    </message>
    <message>
        <source>its vertices have no property &quot;%1&quot;; accepted: x, y and z</source>
        <translation>ihre Ecken haben keine Eigenschaft „%1“; erlaubt: x, y und z</translation>
    </message>
    <message>
        <source>meshes without volume, as their transform flattens them</source>
        <translation>Netze ohne Volumen, da ihre Transformation sie flach macht</translation>
    </message>
    <message>
        <source>%1, one for each pin</source>
        <translation>%1, je Nadel einer</translation>
    </message>
    <message>
        <source>a shape is missing; accepted: &quot;size&quot; of a sheet, &quot;path&quot; of a cable, &quot;of&quot; for a mesh, or &quot;again&quot;</source>
        <translation>eine Form fehlt; zulässig: „size“ eines Tuchs, „path“ eines Kabels, „of“ für ein Netz oder „again“</translation>
    </message>
    <message>
        <source>it is not flexible</source>
        <translation>es ist nicht biegsam</translation>
    </message>
    <message>
        <source>its pins have not all moved alike</source>
        <translation>seine Nadeln haben sich nicht alle gleich bewegt</translation>
    </message>
    <message>
        <source>the file does not say how it began</source>
        <translation>die Datei sagt nicht, wie es begann</translation>
    </message>
    <message>
        <source>it fits nowhere above its place</source>
        <translation>es passt nirgends über seinen Platz</translation>
    </message>
    <message>
        <source>no place near is free</source>
        <translation>kein Platz in der Nähe ist frei</translation>
    </message>
    <message>
        <source>the joint &quot;%1&quot; is not written: its link hangs in another one, too</source>
        <translation>das Gelenk „%1“ wird nicht geschrieben: sein Glied hängt auch an einem anderen</translation>
    </message>
    <message>
        <source>the joint &quot;%1&quot; is written as fixed: %2</source>
        <translation>das Gelenk „%1“ wird als fest geschrieben: %2</translation>
    </message>
    <message>
        <source>the joint &quot;%1&quot; would slide: friction of %2 N holds it</source>
        <translation>das Gelenk „%1“ würde gleiten: Reibung von %2 N hält es</translation>
    </message>
    <message>
        <source>the joint &quot;%1&quot; would swing: friction of %2 N m holds it</source>
        <translation>das Gelenk „%1“ würde schwingen: Reibung von %2 N m hält es</translation>
    </message>
    <message>
        <source>the time is over</source>
        <translation>die Zeit ist um</translation>
    </message>
    <message>
        <source>there is no object %1; accepted: names of objects</source>
        <translation>es gibt kein Objekt %1; erlaubt: Namen von Objekten</translation>
    </message>
    <message>
        <source>&quot;%1&quot; hangs in &quot;%2&quot; by a joint; accepted: objects without joints</source>
        <translation>„%1“ hängt mit einem Gelenk an „%2“; erlaubt: Objekte ohne Gelenke</translation>
    </message>
    <message>
        <source>a joint without a position; accepted: both</source>
        <translation>ein Gelenk ohne Position; erlaubt: beides</translation>
    </message>
    <message>
        <source>a limit that the joint has</source>
        <translation>eine Grenze, die das Gelenk hat</translation>
    </message>
    <message>
        <source>a number from &quot;lower&quot; on</source>
        <translation>eine Zahl ab „lower“</translation>
    </message>
    <message>
        <source>a slide has no place; accepted: with &quot;hinge&quot;</source>
        <translation>ein Schubgelenk hat keinen Ort; erlaubt: mit „hinge“</translation>
    </message>
    <message>
        <source>accepted: &quot;slide&quot;, the axis of a drawer, or &quot;hinge&quot;, that of a door</source>
        <translation>erlaubt: „slide“, die Achse einer Schublade, oder „hinge“, die einer Tür</translation>
    </message>
    <message>
        <source>accepted: one of &quot;to&quot;, &quot;by&quot; and &quot;until&quot;</source>
        <translation>erlaubt: eines von „to“, „by“ und „until“</translation>
    </message>
    <message>
        <source>an object that hangs in a joint: %1</source>
        <translation>ein Objekt, das an einem Gelenk hängt: %1</translation>
    </message>
    <message>
        <source>an object that hangs in a joint: there is none</source>
        <translation>ein Objekt, das an einem Gelenk hängt: es gibt keines</translation>
    </message>
    <message>
        <source>none: the scene has no slides and hinges</source>
        <translation>keines: die Szene hat keine Schub- und Drehgelenke</translation>
    </message>
    <message>
        <source>things: others hang in %1 by joints; accepted: objects without joints</source>
        <translation>things: an %1 hängen andere mit Gelenken; erlaubt: Objekte ohne Gelenke</translation>
    </message>
    <message>
        <source>the name of one of /objects before it, with a position</source>
        <translation>der Name eines der /objects davor, das eine Position hat</translation>
    </message>
    <message>
        <source>the joint of &quot;%1&quot; was changed</source>
        <translation>das Gelenk von „%1“ wurde geändert</translation>
    </message>
    <message>
        <source>&quot;%1&quot; follows it</source>
        <translation>„%1“ folgt ihm</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no value of its own: it follows &quot;%2&quot;</source>
        <translation>„%1“ hat keinen eigenen Wert: es folgt „%2“</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2; accepted: numbers up to %3</source>
        <translation>„%1“ ist %2; erlaubt: Zahlen bis %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no folder; accepted: folders that scenes may read</source>
        <translation>„%1“ ist kein Ordner; erlaubt: Ordner, die Szenen lesen dürfen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no slide or hinge of the scene</source>
        <translation>„%1“ ist kein Schub- oder Drehgelenk der Szene</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not fetched; accepted: files on this machine</source>
        <translation>„%1“ wird nicht geholt; erlaubt: Dateien auf diesem Rechner</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is of type %2; accepted: a number, metres or radians</source>
        <translation>„%1“ ist vom Typ %2; erlaubt: eine Zahl, Meter oder Radiant</translation>
    </message>
    <message>
        <source>&quot;free&quot;, &quot;ball&quot;, &quot;slide&quot; or &quot;hinge&quot;</source>
        <translation>„free“, „ball“, „slide“ oder „hinge“</translation>
    </message>
    <message>
        <source>%1 files, %2 within each other</source>
        <translation>%1 Dateien, %2 ineinander</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 Zahlen</translation>
    </message>
    <message>
        <source>%1 positive numbers</source>
        <translation>%1 positive Zahlen</translation>
    </message>
    <message>
        <source>%1 to %2 numbers</source>
        <translation>%1 bis %2 Zahlen</translation>
    </message>
    <message>
        <source>%1: %2=&quot;%3&quot;; accepted: %4</source>
        <translation>%1: %2=&quot;%3&quot;; erlaubt: %4</translation>
    </message>
    <message>
        <source>%1: align is not read</source>
        <translation>%1: align wird nicht gelesen</translation>
    </message>
    <message>
        <source>%1: has no parent or no child</source>
        <translation>%1: hat kein übergeordnetes oder kein untergeordnetes Glied</translation>
    </message>
    <message>
        <source>%1: is not read</source>
        <translation>%1: wird nicht gelesen</translation>
    </message>
    <message>
        <source>%1: nested too deeply</source>
        <translation>%1: zu tief verschachtelt</translation>
    </message>
    <message>
        <source>%1: too many bodies; accepted: %2, %3 within each other</source>
        <translation>%1: zu viele Körper; erlaubt: %2, %3 ineinander</translation>
    </message>
    <message>
        <source>%1: too many frames</source>
        <translation>%1: zu viele Bezugssysteme</translation>
    </message>
    <message>
        <source>%1: too many frames in a row; accepted: %2</source>
        <translation>%1: zu viele Bezugssysteme hintereinander; erlaubt: %2</translation>
    </message>
    <message>
        <source>%1: too many links; accepted: %2</source>
        <translation>%1: zu viele Glieder; erlaubt: %2</translation>
    </message>
    <message>
        <source>0 to 4294967295</source>
        <translation>0 bis 4294967295</translation>
    </message>
    <message>
        <source>MuJoCo reads no keyframe where a tag makes several bodies</source>
        <translation>MuJoCo liest keinen Keyframe, wo eine Marke mehrere Körper erzeugt</translation>
    </message>
    <message>
        <source>URDF has no pose for it</source>
        <translation>URDF hat keine Pose dafür</translation>
    </message>
    <message>
        <source>a class of the section &lt;default&gt;</source>
        <translation>eine Klasse des Abschnitts &lt;default&gt;</translation>
    </message>
    <message>
        <source>a direction</source>
        <translation>eine Richtung</translation>
    </message>
    <message>
        <source>a direction other than zero</source>
        <translation>eine Richtung, die nicht null ist</translation>
    </message>
    <message>
        <source>a flat mesh has no hull</source>
        <translation>ein flaches Netz hat keine Hülle</translation>
    </message>
    <message>
        <source>a geom fitted to a mesh is not read</source>
        <translation>ein an ein Netz angepasstes geom wird nicht gelesen</translation>
    </message>
    <message>
        <source>a geom of the type &quot;%1&quot; is not read</source>
        <translation>ein geom vom Typ „%1“ wird nicht gelesen</translation>
    </message>
    <message>
        <source>a link that no other joint has as its child</source>
        <translation>ein Glied, das an keinem anderen Gelenk hängt</translation>
    </message>
    <message>
        <source>a name that no other link has</source>
        <translation>ein Name, den kein anderes Glied hat</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>ein Wert</translation>
    </message>
    <message>
        <source>accepted: {&quot;joint&quot;: number, ...}</source>
        <translation>erlaubt: {&quot;Gelenk&quot;: Zahl, ...}</translation>
    </message>
    <message>
        <source>an equality of the file holds it</source>
        <translation>eine Gleichheit (equality) der Datei hält es</translation>
    </message>
    <message>
        <source>axes that differ</source>
        <translation>verschiedene Achsen</translation>
    </message>
    <message>
        <source>begins with &lt;%1&gt;; accepted: %2</source>
        <translation>beginnt mit &lt;%1&gt;; erlaubt: %2</translation>
    </message>
    <message>
        <source>begins with &lt;%1&gt;; accepted: &lt;mujoco&gt;</source>
        <translation>beginnt mit &lt;%1&gt;; erlaubt: &lt;mujoco&gt;</translation>
    </message>
    <message>
        <source>begins with &lt;%1&gt;; accepted: &lt;robot&gt;</source>
        <translation>beginnt mit &lt;%1&gt;; erlaubt: &lt;robot&gt;</translation>
    </message>
    <message>
        <source>begins with &lt;%1&gt;; accepted: &lt;sdf&gt;</source>
        <translation>beginnt mit &lt;%1&gt;; erlaubt: &lt;sdf&gt;</translation>
    </message>
    <message>
        <source>cannot be read, or is larger than the %1 bytes left</source>
        <translation>kann nicht gelesen werden oder ist größer als die übrigen %1 Bytes</translation>
    </message>
    <message>
        <source>cannot be read; accepted: a file of at most %1 bytes</source>
        <translation>kann nicht gelesen werden; erlaubt: eine Datei von höchstens %1 Bytes</translation>
    </message>
    <message>
        <source>class</source>
        <translation>class</translation>
    </message>
    <message>
        <source>constraints (equality) are not read: bodies stand as they are</source>
        <translation>Bindungen (equality) werden nicht gelesen: Körper stehen, wie sie sind</translation>
    </message>
    <message>
        <source>count</source>
        <translation>count</translation>
    </message>
    <message>
        <source>eulerseq</source>
        <translation>eulerseq</translation>
    </message>
    <message>
        <source>face</source>
        <translation>face</translation>
    </message>
    <message>
        <source>file</source>
        <translation>file</translation>
    </message>
    <message>
        <source>frames without a circle</source>
        <translation>Bezugssysteme ohne Kreis</translation>
    </message>
    <message>
        <source>fromto</source>
        <translation>fromto</translation>
    </message>
    <message>
        <source>gravity is &quot;%1&quot;; judged as if it acted along -z</source>
        <translation>die Schwerkraft ist „%1“; beurteilt, als wirkte sie entlang -z</translation>
    </message>
    <message>
        <source>has global coordinates, which MuJoCo no longer reads</source>
        <translation>hat globale Koordinaten, die MuJoCo nicht mehr liest</translation>
    </message>
    <message>
        <source>has joints in a circle</source>
        <translation>hat Gelenke in einem Kreis</translation>
    </message>
    <message>
        <source>has joints in a circle; accepted: trees of links</source>
        <translation>hat Gelenke in einem Kreis; erlaubt: Bäume von Gliedern</translation>
    </message>
    <message>
        <source>has no body %1 that collides</source>
        <translation>hat keinen Körper %1, der kollidiert</translation>
    </message>
    <message>
        <source>has no keyframe &quot;%1&quot;; accepted: %2</source>
        <translation>hat keinen Keyframe „%1“; erlaubt: %2</translation>
    </message>
    <message>
        <source>has no model</source>
        <translation>hat kein Modell</translation>
    </message>
    <message>
        <source>has too many faces that collide; accepted: %1</source>
        <translation>hat zu viele Flächen, die kollidieren; erlaubt: %1</translation>
    </message>
    <message>
        <source>has too many links in a row; accepted: %1</source>
        <translation>hat zu viele Glieder hintereinander; erlaubt: %1</translation>
    </message>
    <message>
        <source>has too many links in joints of joints</source>
        <translation>hat zu viele Glieder in Gelenken von Gelenken</translation>
    </message>
    <message>
        <source>has too many links; accepted: %1</source>
        <translation>hat zu viele Glieder; erlaubt: %1</translation>
    </message>
    <message>
        <source>is a macro file; expand it first: xacro %1 &gt; robot.urdf</source>
        <translation>ist eine Makrodatei; erst auflösen: xacro %1 &gt; robot.urdf</translation>
    </message>
    <message>
        <source>is no articulation; accepted: MJCF, URDF and SDF (.xml .mjcf .urdf .sdf)</source>
        <translation>ist nichts mit Gelenken; erlaubt: MJCF, URDF und SDF (.xml .mjcf .urdf .sdf)</translation>
    </message>
    <message>
        <source>is no file</source>
        <translation>ist keine Datei</translation>
    </message>
    <message>
        <source>is no mesh of MuJoCo</source>
        <translation>ist kein Netz von MuJoCo</translation>
    </message>
    <message>
        <source>is no mesh of MuJoCo: a face names no vertex</source>
        <translation>ist kein Netz von MuJoCo: eine Fläche nennt keine Ecke</translation>
    </message>
    <message>
        <source>is no mesh of MuJoCo: its counts do not fit its size</source>
        <translation>ist kein Netz von MuJoCo: seine Anzahlen passen nicht zu seiner Größe</translation>
    </message>
    <message>
        <source>is no name for a layer over a scene of USD; accepted: .usda</source>
        <translation>ist kein Name für eine Ebene über einer USD-Szene; erlaubt: .usda</translation>
    </message>
    <message>
        <source>is not read</source>
        <translation>wird nicht gelesen</translation>
    </message>
    <message>
        <source>is outside the folder of the scene, and would be written outside that of the output; accepted: an output in the scene&apos;s folder, if nothing changes in this file</source>
        <translation>liegt außerhalb des Ordners der Szene und würde außerhalb des Ordners der Ausgabe geschrieben; erlaubt: eine Ausgabe im Ordner der Szene, wenn sich in dieser Datei nichts ändert</translation>
    </message>
    <message>
        <source>it closes a chain of joints</source>
        <translation>es schließt eine Kette von Gelenken</translation>
    </message>
    <message>
        <source>it does not move</source>
        <translation>es bewegt sich nicht</translation>
    </message>
    <message>
        <source>it follows &quot;%1&quot;</source>
        <translation>es folgt „%1“</translation>
    </message>
    <message>
        <source>it is part of another model</source>
        <translation>es gehört zu einem anderen Modell</translation>
    </message>
    <message>
        <source>its &lt;include&gt; has no &lt;pose&gt;</source>
        <translation>sein &lt;include&gt; hat keine &lt;pose&gt;</translation>
    </message>
    <message>
        <source>its first keyframe has no positions</source>
        <translation>ihr erster Keyframe hat keine Positionen</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>Zeile %1, Spalte %2: %3</translation>
    </message>
    <message>
        <source>link</source>
        <translation>link</translation>
    </message>
    <message>
        <source>margins from %1 to %2 mm are not kept: objects rest in contact</source>
        <translation>Abstände von %1 bis %2 mm werden nicht eingehalten: Objekte ruhen in Berührung</translation>
    </message>
    <message>
        <source>more than %1 files</source>
        <translation>mehr als %1 Dateien</translation>
    </message>
    <message>
        <source>name</source>
        <translation>name</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which is outside its folder; accepted: files in the folder of the scene, of its package, or of --root, or below</source>
        <translation>nennt „%1“ außerhalb ihres Ordners; erlaubt: Dateien im Ordner der Szene, ihres Pakets oder von --root, oder darunter</translation>
    </message>
    <message>
        <source>no mesh is named &quot;%1&quot;</source>
        <translation>kein Netz heißt „%1“</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>numbers of vertices</source>
        <translation>Nummern von Ecken</translation>
    </message>
    <message>
        <source>pairs (contact) are judged by the friction of their geoms</source>
        <translation>Paare (contact) werden nach der Reibung ihrer geoms beurteilt</translation>
    </message>
    <message>
        <source>size</source>
        <translation>size</translation>
    </message>
    <message>
        <source>the joint &quot;%1&quot; is not read: it is not between links of one model; they stay where they are</source>
        <translation>das Gelenk „%1“ wird nicht gelesen: es ist nicht zwischen Gliedern eines Modells; sie bleiben, wo sie sind</translation>
    </message>
    <message>
        <source>the joint &quot;%1&quot; is of type %2: its link stays where it is</source>
        <translation>das Gelenk „%1“ ist vom Typ %2: sein Glied bleibt, wo es ist</translation>
    </message>
    <message>
        <source>the mass of &quot;%1&quot; is not used: %2</source>
        <translation>die Masse von „%1“ wird nicht benutzt: %2</translation>
    </message>
    <message>
        <source>the name of a frame, a link or a model</source>
        <translation>der Name eines Bezugssystems, eines Glieds oder eines Modells</translation>
    </message>
    <message>
        <source>the name of a link</source>
        <translation>der Name eines Glieds</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>der Pfad einer Datei</translation>
    </message>
    <message>
        <source>the plane of &quot;%1&quot;, which moves, is not read</source>
        <translation>die Ebene von „%1“, das sich bewegt, wird nicht gelesen</translation>
    </message>
    <message>
        <source>the state of the world (&lt;state&gt;) is not read: models stand where they are defined</source>
        <translation>der Zustand der Welt (&lt;state&gt;) wird nicht gelesen: Modelle stehen, wo sie definiert sind</translation>
    </message>
    <message>
        <source>the values of joints are those of %1</source>
        <translation>die Werte der Gelenke sind die von %1</translation>
    </message>
    <message>
        <source>there is more of this kind</source>
        <translation>es gibt mehr von dieser Art</translation>
    </message>
    <message>
        <source>things: %1 hangs in a joint; accepted: objects that may move, onto it, too</source>
        <translation>things: %1 hängt in einem Gelenk; erlaubt: Objekte, die sich bewegen dürfen, auch auf dieses</translation>
    </message>
    <message>
        <source>three letters of xyzXYZ</source>
        <translation>drei Buchstaben aus xyzXYZ</translation>
    </message>
    <message>
        <source>two points that differ</source>
        <translation>zwei verschiedene Punkte</translation>
    </message>
    <message>
        <source>type</source>
        <translation>type</translation>
    </message>
    <message>
        <source>whole numbers of 32 bits</source>
        <translation>ganze Zahlen von 32 Bit</translation>
    </message>
    <message>
        <source>xyaxes</source>
        <translation>xyaxes</translation>
    </message>
    <message>
        <source>xyz</source>
        <translation>xyz</translation>
    </message>
    <message>
        <source>%1 comes to rest on the rim of %2</source>
        <translation>%1 kommt auf dem Rand von %2 zur Ruhe</translation>
    </message>
    <message>
        <source>cannot hold poses of %1; accepted: numbers of joints of MJCF</source>
        <translation>kann keine Lagen von %1 aufnehmen; erlaubt: Zahlen der Gelenke von MJCF</translation>
    </message>
    <message>
        <source>has the type &quot;%1&quot; and the shape (%2); accepted: %3 numbers of the joints (qpos) in one row, float64 or float32</source>
        <translation>hat den Typ „%1“ und die Form (%2); erlaubt: %3 Zahlen der Gelenke (qpos) in einer Zeile, float64 oder float32</translation>
    </message>
    <message>
        <source>is binary USD; accepted: USD as text (usdcat %1 -o scene.usda)</source>
        <translation>ist binäres USD; erlaubt: USD als Text (usdcat %1 -o scene.usda)</translation>
    </message>
    <message>
        <source>is no array of NumPy (.npy)</source>
        <translation>ist kein Feld von NumPy (.npy)</translation>
    </message>
    <message>
        <source>is no place for poses that %1 has; accepted: .npy</source>
        <translation>ist kein Ort für Lagen, die %1 hat; erlaubt: .npy</translation>
    </message>
    <message>
        <source>its tag makes several bodies; accepted: an output NAME.npy, which has the numbers of all joints (qpos)</source>
        <translation>sein Element erzeugt mehrere Körper; erlaubt: eine Ausgabe NAME.npy, die die Zahlen aller Gelenke (qpos) hat</translation>
    </message>
    <message>
        <source>margins of %1 mm are too large for a scene of this size, and are not kept: objects rest in contact</source>
        <translation>Abstände von %1 mm sind zu groß für eine Szene dieser Größe und werden nicht eingehalten: Objekte ruhen in Berührung</translation>
    </message>
    <message>
        <source>number %1 is not finite</source>
        <translation>Zahl %1 ist nicht endlich</translation>
    </message>
    <message>
        <source>pairs nearer to each other than the file&apos;s margins: %1, by up to %2 mm; their engine moves them apart</source>
        <translation>Paare, die einander näher sind als die Abstände der Datei: %1, um bis zu %2 mm; ihre Engine schiebt sie auseinander</translation>
    </message>
    <message>
        <source>would hold %1; accepted: %2</source>
        <translation>würde %1 enthalten; erlaubt: %2</translation>
    </message>
    <message>
        <source>whether objects rest, of %1, among them &quot;%2&quot;: the time is over</source>
        <translation>bei %1 Objekten, darunter „%2“, ob sie ruhen: die Zeit ist um</translation>
    </message>
    <message>
        <source>whether pairs interpenetrate, of %1: the time is over</source>
        <translation>bei %1 Paaren, ob sie sich durchdringen: die Zeit ist um</translation>
    </message>
    <message>
        <source>whether the whole stands: %1</source>
        <translation>ob das Ganze steht: %1</translation>
    </message>
    <message>
        <source>no body of the file collides</source>
        <translation>kein Körper der Datei kollidiert</translation>
    </message>
</context>
<context>
    <name>results</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>der Boden</translation>
    </message>
    <message>
        <source>stopped by %1</source>
        <translation>aufgehalten, im Weg: %1</translation>
    </message>
    <message>
        <source>stopped by a step of %1 higher than %2</source>
        <translation>aufgehalten von einer Stufe von %1, die höher ist als %2</translation>
    </message>
    <message>
        <source>gave way: %1</source>
        <translation>nachgegeben: %1</translation>
    </message>
    <message>
        <source>%1 left without support</source>
        <translation>%1 ohne Halt</translation>
    </message>
    <message>
        <source>interpenetrates %1</source>
        <translation>durchdringt %1</translation>
    </message>
    <message>
        <source>rests on what is held, unsupported or invalid: %1</source>
        <translation>ruht auf Gehaltenem, Ungestütztem oder Ungültigem: %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 um %2</translation>
    </message>
    <message>
        <source>stopped at a drop deeper than %1</source>
        <translation>hält vor einer Kante, die tiefer abfällt als %1</translation>
    </message>
    <message numerus="yes">
        <source>%n objects moved, by %1 at most</source>
        <translation>
            <numerusform>%n Objekt bewegt, um höchstens %1</numerusform>
            <numerusform>%n Objekte bewegt, um höchstens %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 supports kept</source>
        <translation>%1 von %2 Auflagen erhalten</translation>
    </message>
    <message>
        <source>%1 stays where it was: %2</source>
        <translation>%1 bleibt, wo es war: %2</translation>
    </message>
    <message>
        <source>at its limit</source>
        <translation>an seiner Grenze</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>tools</name>
    <message>
        <source>Drag a ring to turn the object; hold Control for steps, or type degrees</source>
        <translation>Einen Ring ziehen, um das Objekt zu drehen; Strg für Schritte, oder Grad eintippen</translation>
    </message>
    <message>
        <source>Drag an arrow, a square or the object itself; type metres, Tab for the axis</source>
        <translation>Pfeil, Quadrat oder das Objekt selbst ziehen; Meter eintippen, Tab für die Achse</translation>
    </message>
    <message>
        <source>Drag an object along the surface it lies on, or a wall it touches (V: its next contact); type x and y meanwhile; Control snaps</source>
        <translation>Ein Objekt auf seiner Fläche oder an einer Wand entlangziehen (V: nächster Kontakt); x und y eintippen; Strg rastet ein</translation>
    </message>
    <message>
        <source>Select the objects to paint copies of, then drag over a surface</source>
        <translation>Die Objekte auswählen, von denen Kopien gemalt werden, dann über eine Fläche ziehen</translation>
    </message>
    <message>
        <source>Drag over a surface: copies are set down along the stroke; what does not fit is left out</source>
        <translation>Über eine Fläche ziehen: Kopien werden entlang des Strichs abgelegt; was nicht passt, fehlt</translation>
    </message>
    <message>
        <source>Click an object to pick it up, or drag it away from its support</source>
        <translation>Ein Objekt anklicken, um es aufzunehmen, oder von seiner Unterlage ziehen</translation>
    </message>
    <message>
        <source>Nothing in hand: click an object to take it; N takes the next one that is not placed yet</source>
        <translation>Nichts in der Hand: ein Objekt anklicken; N nimmt das nächste noch nicht abgelegte</translation>
    </message>
    <message>
        <source>Click a contact point, edge or area, then drag to turn about it; hold Control for steps, or type degrees</source>
        <translation>Punkt, Kante oder Fläche eines Kontakts anklicken, dann ziehen; Strg für Schritte, oder Grad eintippen</translation>
    </message>
    <message>
        <source>Tab: next axis, Return: done, Escape: cancel</source>
        <translation>Tab: nächste Achse, Eingabe: fertig, Escape: abbrechen</translation>
    </message>
    <message>
        <source>steps of %1°</source>
        <translation>Schritte von %1°</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>der Boden</translation>
    </message>
    <message>
        <source>face of %1</source>
        <translation>Fläche von %1</translation>
    </message>
    <message>
        <source>corner of %1</source>
        <translation>Ecke von %1</translation>
    </message>
    <message>
        <source>edge of %1</source>
        <translation>Kante von %1</translation>
    </message>
    <message>
        <source>grid %1 mm</source>
        <translation>Raster %1 mm</translation>
    </message>
    <message numerus="yes">
        <source>%n copies</source>
        <translation>
            <numerusform>%n Kopie</numerusform>
            <numerusform>%n Kopien</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n objects in turn</source>
        <translation>
            <numerusform>%n Objekt reihum</numerusform>
            <numerusform>%n Objekte reihum</numerusform>
        </translation>
    </message>
    <message>
        <source>Hold the button over a bowl, a box or a heap: copies fall onto each other there until you let go</source>
        <translation>Taste über einer Schale, einer Kiste oder einem Haufen gedrückt halten: Kopien fallen dort aufeinander, bis Sie loslassen</translation>
    </message>
    <message>
        <source>Click where you want it; wheel: turn; L: next way to lie; Alt: from just above that point; Escape puts it back</source>
        <translation>Klicken Sie, wo es hin soll; Rad: drehen; L: nächste Lage; Alt: von knapp über dem Punkt; Escape legt es zurück</translation>
    </message>
    <message>
        <source>Wheel: turn; L: next way to lie; Shift: lift; Control: snap; Escape: put it back</source>
        <translation>Rad: drehen; L: nächste Lage; Umschalt: heben; Strg: einrasten; Escape: zurücklegen</translation>
    </message>
    <message>
        <source>%1 lies so already, or cannot lie so</source>
        <translation>%1 liegt schon so, oder kann es nicht</translation>
    </message>
    <message>
        <source>%1 is locked: unlock it to put it elsewhere</source>
        <translation>%1 ist gesperrt: zum Umstellen entsperren</translation>
    </message>
    <message>
        <source>%1 is fixed: unfix it to put it elsewhere</source>
        <translation>%1 ist fest: zum Umstellen lösen</translation>
    </message>
    <message>
        <source>Click: the sheet comes down there; wheel: turn; Escape stops it</source>
        <translation>Klicken: Das Tuch fällt dort herab; Rad: drehen; Escape bricht ab</translation>
    </message>
    <message>
        <source>Click where the cable begins; an object that you click holds its end</source>
        <translation>Klicken, wo das Kabel beginnt; ein angeklicktes Objekt hält sein Ende</translation>
    </message>
    <message>
        <source>Click where it goes; Return or a double click ends it; Backspace takes the last place back, Escape all</source>
        <translation>Klicken, wohin es geht; Eingabe oder Doppelklick beendet es; Rücktaste nimmt die letzte Stelle zurück, Escape alle</translation>
    </message>
    <message>
        <source>Drag an object to move it, a drawer or door to open it; click to select, Shift-click to add; drag from the ground for a selection box</source>
        <translation>Objekt ziehen: bewegen, Schublade oder Tür ziehen: öffnen; Klick wählt aus, mit Umschalt dazu; vom Boden aus gezogen entsteht ein Auswahlrahmen</translation>
    </message>
</context>
<context>
    <name>trivet::edit</name>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Middle, or Alt + Left</source>
        <translation>Mitte oder Alt + Links</translation>
    </message>
    <message>
        <source>Orbit (perspective), pan (other windows)</source>
        <translation>Umkreisen (Perspektive), schwenken (andere)</translation>
    </message>
    <message>
        <source>Shift + Middle, or Right</source>
        <translation>Umschalt + Mitte oder Rechts</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Schwenken</translation>
    </message>
    <message>
        <source>Wheel, or Control + Middle</source>
        <translation>Rad oder Strg + Mitte</translation>
    </message>
    <message>
        <source>Zoom towards the mouse</source>
        <translation>Zur Maus zoomen</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>Menu for the selection</source>
        <translation>Menü der Auswahl</translation>
    </message>
    <message>
        <source>Double click on a title</source>
        <translation>Doppelklick auf einen Titel</translation>
    </message>
    <message>
        <source>Maximise the window, and restore it</source>
        <translation>Fenster maximieren und wiederherstellen</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Escape</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>A table in two minutes</source>
        <translation>Ein Tisch in zwei Minuten</translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation>%1 von</translation>
    </message>
    <message>
        <source>%1 to</source>
        <translation>%1 bis</translation>
    </message>
    <message>
        <source>Array of %1</source>
        <translation>Reihe von %1</translation>
    </message>
    <message>
        <source>Put</source>
        <translation>Ablegen</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>Along x</source>
        <translation>Entlang x</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>Entlang y</translation>
    </message>
    <message>
        <source>Step x</source>
        <translation>Schritt x</translation>
    </message>
    <message>
        <source>Step y</source>
        <translation>Schritt y</translation>
    </message>
    <message>
        <source>Step z</source>
        <translation>Schritt z</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Mitte x</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Mitte y</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Turn each with its place</source>
        <translation>Jedes mit seiner Stelle drehen</translation>
    </message>
    <message>
        <source>The first is the object itself. Each copy is put from just above; what is refused is left out.</source>
        <translation>Das erste ist das Objekt selbst. Jede Kopie wird von knapp darüber abgelegt; was abgelehnt wird, fehlt.</translation>
    </message>
    <message>
        <source>Put all that are not placed</source>
        <translation>Alle ablegen, die es nicht sind</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Verstreuen</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>der Boden</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>In a rectangle</source>
        <translation>In einem Rechteck</translation>
    </message>
    <message>
        <source>Keep away</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Gedreht</translation>
    </message>
    <message>
        <source>not</source>
        <translation>nicht</translation>
    </message>
    <message>
        <source>about the vertical</source>
        <translation>um die Senkrechte</translation>
    </message>
    <message>
        <source>anyhow</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>lower sides</source>
        <translation>unteren Seiten</translation>
    </message>
    <message>
        <source>centres</source>
        <translation>Mitten</translation>
    </message>
    <message>
        <source>upper sides</source>
        <translation>oberen Seiten</translation>
    </message>
    <message>
        <source>equal gaps</source>
        <translation>gleichen Lücken</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Entlang</translation>
    </message>
    <message>
        <source>To the object that was selected last; equal gaps leave the outermost two. Each is put from just above, with its loads.</source>
        <translation>Am zuletzt gewählten Objekt; gleiche Lücken lassen die äußersten zwei. Jedes wird von knapp darüber abgelegt, mit seinen Lasten.</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>Himmelblau</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>Zinnober</translation>
    </message>
    <message>
        <source>Purple</source>
        <translation>Purpur</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Control + Wheel</source>
        <translation>Strg + Rad</translation>
    </message>
    <message>
        <source>Move the section plane of the window</source>
        <translation>Schnittebene des Fensters verschieben</translation>
    </message>
    <message>
        <source>Control during a drag</source>
        <translation>Strg beim Ziehen</translation>
    </message>
    <message>
        <source>Snap, or not if the magnet is on</source>
        <translation>Einrasten, oder nicht, wenn der Magnet an ist</translation>
    </message>
    <message>
        <source>Shift + Left</source>
        <translation>Umschalt + Links</translation>
    </message>
    <message>
        <source>Click: add to the selection. Drag: lift the object</source>
        <translation>Klick: zur Auswahl dazu. Ziehen: das Objekt heben</translation>
    </message>
    <message>
        <source>Shift + Control + Left</source>
        <translation>Umschalt + Strg + Links</translation>
    </message>
    <message>
        <source>Box, also from an object</source>
        <translation>Rahmen, auch von einem Objekt aus</translation>
    </message>
    <message>
        <source>Wheel, or , and . with an object in hand</source>
        <translation>Rad, oder , und . mit einem Objekt in der Hand</translation>
    </message>
    <message>
        <source>Turn it about the vertical</source>
        <translation>Es um die Senkrechte drehen</translation>
    </message>
    <message>
        <source>L with an object in hand</source>
        <translation>L mit einem Objekt in der Hand</translation>
    </message>
    <message>
        <source>Next way in which it can lie, the nearest first</source>
        <translation>Nächste Lage, in der es liegen kann, die nächstliegende zuerst</translation>
    </message>
    <message>
        <source>Put back what is in hand; cancel the action; close messages</source>
        <translation>Zurücklegen, was in der Hand ist; Aktion abbrechen; Meldungen schließen</translation>
    </message>
    <message>
        <source>&lt;h2&gt;A table in two minutes&lt;/h2&gt;&lt;ol&gt;&lt;li&gt;&lt;b&gt;File, Import models…&lt;/b&gt; (or drop files onto the window): choose the table, its unit, and &lt;i&gt;fixed&lt;/i&gt;. Click the place for it on the floor.&lt;/li&gt;&lt;li&gt;Import plates, cups and spoons in the same way. After the import, each  is shown as a ghost where it would come to rest. Click on the table: it falls, settles, and lies at rest. Into a shelf: click on its board.&lt;/li&gt;&lt;li&gt;To put another object, press &lt;b&gt;N&lt;/b&gt; for the next one, or choose it in the tree, then press &lt;b&gt;W&lt;/b&gt; (Put). A red ghost says why it cannot be there.&lt;/li&gt;&lt;li&gt;&lt;b&gt;Drag&lt;/b&gt; a cup along the table, without a tool: it slides, hangs back where it is blocked, and climbs onto the saucer, the tray or the shelf under the mouse. A ghost shows where it will come to rest; let go, and it settles. Meanwhile the wheel turns it, &lt;b&gt;L&lt;/b&gt; lays it otherwise, Shift lifts it, Control snaps, Escape puts it back.&lt;/li&gt;&lt;li&gt;&lt;b&gt;E&lt;/b&gt; (Push): the same along the surface alone, with steps and walls as set.&lt;/li&gt;&lt;li&gt;&lt;b&gt;R&lt;/b&gt; (Turn): click a contact point, edge or area in the constraint window and drag about it; or drag to turn about the contact&apos;s normal.&lt;/li&gt;&lt;li&gt;&lt;b&gt;T&lt;/b&gt; (Pick up), &lt;b&gt;G&lt;/b&gt; (Move) and &lt;b&gt;H&lt;/b&gt; (Rotate) move it through the air.&lt;/li&gt;&lt;li&gt;&lt;b&gt;Control+D&lt;/b&gt; makes a copy. &lt;b&gt;Control+Z&lt;/b&gt; undoes any number of steps; the History tab jumps to any of them.&lt;/li&gt;&lt;li&gt;&lt;b&gt;Control+S&lt;/b&gt; saves the scene as .glb, which other programs can read. &lt;b&gt;File, Picture…&lt;/b&gt; renders a picture of the current view.&lt;/li&gt;&lt;/ol&gt;&lt;p&gt;When an operation is refused, a bar gives the reason, and the obstacles are marked. The scene is unchanged.&lt;/p&gt;</source>
        <translation>&lt;h2&gt;Ein Tisch in zwei Minuten&lt;/h2&gt;&lt;ol&gt;&lt;li&gt;&lt;b&gt;Datei, Modelle importieren…&lt;/b&gt; (oder Dateien in dieses Fenster ziehen): den Tisch, seine Einheit und &lt;i&gt;fest&lt;/i&gt; wählen. Auf dem Boden anklicken, wohin er soll.&lt;/li&gt;&lt;li&gt;Teller, Tassen und Löffel ebenso importieren. Danach zeigt ein Geist jedes dort, wo es zur Ruhe käme. Auf den Tisch klicken: es fällt und liegt dann ruhig. In ein Regal: auf dessen Brett klicken.&lt;/li&gt;&lt;li&gt;Das nächste Objekt: &lt;b&gt;N&lt;/b&gt; drücken, oder es im Baum wählen und &lt;b&gt;W&lt;/b&gt; (Ablegen) drücken. Ein roter Geist sagt, warum es dort nicht sein kann.&lt;/li&gt;&lt;li&gt;Eine Tasse ohne Werkzeug über den Tisch &lt;b&gt;ziehen&lt;/b&gt;: sie gleitet, bleibt zurück, wo ihr etwas im Weg ist, und steigt auf Untertasse, Tablett oder Regal unter der Maus. Ein Geist zeigt, wo sie zur Ruhe kommt; loslassen, und sie liegt. Dabei dreht das Rad, &lt;b&gt;L&lt;/b&gt; legt sie anders, Umschalt hebt, Strg rastet ein, Escape legt zurück.&lt;/li&gt;&lt;li&gt;&lt;b&gt;E&lt;/b&gt; (Schieben): dasselbe nur entlang der Fläche, mit Stufen und Wänden wie eingestellt.&lt;/li&gt;&lt;li&gt;&lt;b&gt;R&lt;/b&gt; (Wenden): im Zwangsfenster Punkt, Kante oder Fläche eines Kontakts anklicken und darum ziehen; oder einfach ziehen, um die Normale des Kontakts.&lt;/li&gt;&lt;li&gt;&lt;b&gt;T&lt;/b&gt; (Aufnehmen), &lt;b&gt;G&lt;/b&gt; (Verschieben) und &lt;b&gt;H&lt;/b&gt; (Drehen) bewegen durch die Luft.&lt;/li&gt;&lt;li&gt;&lt;b&gt;Strg+D&lt;/b&gt; macht eine Kopie. &lt;b&gt;Strg+Z&lt;/b&gt; nimmt beliebig viele Schritte zurück; der Reiter „Verlauf“ springt zu jedem.&lt;/li&gt;&lt;li&gt;&lt;b&gt;Strg+S&lt;/b&gt; speichert die Szene als .glb, das andere Programme lesen. &lt;b&gt;Datei, Bild…&lt;/b&gt; rendert ein Bild der Ansicht.&lt;/li&gt;&lt;/ol&gt;&lt;p&gt;Wird eine Operation abgelehnt, nennt eine Leiste den Grund, und was im Weg ist, wird markiert. Die Szene bleibt, wie sie war.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>As a pile, on each other</source>
        <translation>Als Haufen, aufeinander</translation>
    </message>
    <message>
        <source>Each object is placed at a random free spot on the selected support, or let fall over its middle as a pile; objects that do not fit are skipped. Cancel keeps what is placed.</source>
        <translation>Jedes Objekt kommt an eine zufällige freie Stelle der gewählten Unterlage, oder fällt als Haufen über ihre Mitte; was nicht passt, wird ausgelassen. Abbrechen behält, was schon liegt.</translation>
    </message>
    <message>
        <source>Drag an object to move it, a drawer or door to open it; click to select; drag from the ground for a box; with another tool, use that</source>
        <translation>Objekt ziehen: bewegen, Schublade oder Tür: öffnen; Klick: auswählen; vom Boden ziehen: Rahmen; mit anderem Werkzeug: dieses</translation>
    </message>
</context>
<context>
    <name>trivet::edit::ArrangeDock</name>
    <message>
        <source>Arrange</source>
        <translation>Anordnen</translation>
    </message>
</context>
<context>
    <name>trivet::edit::ArrangePanel</name>
    <message>
        <source>Swap</source>
        <translation>Tauschen</translation>
    </message>
    <message>
        <source>Swap the two objects</source>
        <translation>Die zwei Objekte tauschen</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Soft, weight</source>
        <translation>Weich, Gewicht</translation>
    </message>
    <message>
        <source>Add constraint</source>
        <translation>Bedingung hinzufügen</translation>
    </message>
    <message>
        <source>Add the constraint to the scene&apos;s</source>
        <translation>Die Bedingung denen der Szene hinzufügen</translation>
    </message>
    <message>
        <source>Constraint</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>All constraints, not of the selected objects alone</source>
        <translation>Alle Bedingungen, nicht nur die der ausgewählten Objekte</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen constraints</source>
        <translation>Die gewählten Bedingungen entfernen</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden…</translation>
    </message>
    <message>
        <source>Load a problem of trivet arrange</source>
        <translation>Eine Aufgabe von trivet arrange laden</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save scene and constraints as a problem of trivet arrange</source>
        <translation>Szene und Bedingungen als Aufgabe von trivet arrange speichern</translation>
    </message>
    <message>
        <source>Selected only</source>
        <translation>Nur ausgewählte</translation>
    </message>
    <message>
        <source>Arrange the selected objects; all others stay</source>
        <translation>Die ausgewählten Objekte anordnen; alle anderen bleiben</translation>
    </message>
    <message>
        <source>Seed </source>
        <translation>Startwert </translation>
    </message>
    <message>
        <source>Turn the wheel for the next solution</source>
        <translation>Am Rad drehen für die nächste Lösung</translation>
    </message>
    <message>
        <source>Arrange</source>
        <translation>Anordnen</translation>
    </message>
    <message>
        <source>Look for an arrangement: a preview</source>
        <translation>Eine Anordnung suchen: Vorschau</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>The next solution: another seed</source>
        <translation>Die nächste Lösung: ein anderer Startwert</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Annehmen</translation>
    </message>
    <message>
        <source>Apply the arrangement, as one step</source>
        <translation>Anordnung übernehmen, als ein Schritt</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>Ablehnen</translation>
    </message>
    <message>
        <source>Leave the scene as it is</source>
        <translation>Die Szene lassen, wie sie ist</translation>
    </message>
    <message>
        <source>Drop the cheapest constraint</source>
        <translation>Billigste Bedingung streichen</translation>
    </message>
    <message>
        <source>Drop the constraint that is nearest to being met, and look again</source>
        <translation>Die Bedingung streichen, die fast erfüllt ist, und neu suchen</translation>
    </message>
    <message>
        <source>Looks for a place for %1</source>
        <translation>Sucht einen Platz für %1</translation>
    </message>
    <message>
        <source>Select two objects: the first is to be … the second</source>
        <translation>Zwei Objekte auswählen: das erste soll … das zweite</translation>
    </message>
    <message>
        <source>% at least</source>
        <translation>% mindestens</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>cm at most</source>
        <translation>cm höchstens</translation>
    </message>
    <message>
        <source>hard</source>
        <translation>hart</translation>
    </message>
    <message>
        <source>A number makes the constraint soft, no number hard</source>
        <translation>Eine Zahl macht die Bedingung weich, keine hart</translation>
    </message>
    <message>
        <source>Select objects that may move</source>
        <translation>Objekte auswählen, die sich bewegen dürfen</translation>
    </message>
    <message>
        <source>There is no object that may move</source>
        <translation>Kein Objekt darf sich bewegen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Looks for an arrangement</source>
        <translation>Sucht eine Anordnung</translation>
    </message>
    <message>
        <source>%1 (seed %2, %3 s)</source>
        <translation>%1 (Startwert %2, %3 s)</translation>
    </message>
    <message>
        <source>Save problem</source>
        <translation>Aufgabe speichern</translation>
    </message>
    <message>
        <source>Problems (*.json)</source>
        <translation>Aufgaben (*.json)</translation>
    </message>
    <message>
        <source>Load constraints</source>
        <translation>Bedingungen laden</translation>
    </message>
    <message>
        <source>This constraint is always hard</source>
        <translation>Diese Bedingung ist immer hart</translation>
    </message>
    <message>
        <source>Weight %1: accepted: a number from 0 to %2, or none for a hard constraint</source>
        <translation>Gewicht %1: möglich ist eine Zahl von 0 bis %2, oder keine für eine harte Bedingung</translation>
    </message>
</context>
<context>
    <name>trivet::edit::AssetBrowser</name>
    <message>
        <source>Folder of models, with those below it</source>
        <translation>Ordner mit Modellen, samt denen darunter</translation>
    </message>
    <message>
        <source>Add folder…</source>
        <translation>Ordner…</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Take this folder out of the list; its files stay</source>
        <translation>Ordner aus der Liste nehmen; seine Dateien bleiben</translation>
    </message>
    <message>
        <source>Search models</source>
        <translation>Modelle suchen</translation>
    </message>
    <message>
        <source>Unit of the files in this folder</source>
        <translation>Einheit der Dateien in diesem Ordner</translation>
    </message>
    <message>
        <source>Unit: likely</source>
        <translation>Einheit: wohl</translation>
    </message>
    <message>
        <source>Unit: %1</source>
        <translation>Einheit: %1</translation>
    </message>
    <message>
        <source>Drag a model into a view, or double click to take it in hand</source>
        <translation>Modell in eine Ansicht ziehen; ein Doppelklick nimmt es in die Hand</translation>
    </message>
    <message>
        <source>Folder of models</source>
        <translation>Ordner mit Modellen</translation>
    </message>
    <message>
        <source>There are no models in this folder and those below it, or they are still being listed.</source>
        <translation>In diesem Ordner und denen darunter sind keine Modelle, oder sie werden noch gesucht.</translation>
    </message>
    <message>
        <source>Add a folder of models (.glb, .gltf, .obj, .stl, .ply, ...). Then drag them from here into a view, or double click one to take it in hand.</source>
        <translation>Fügen Sie einen Ordner mit Modellen hinzu (.glb, .gltf, .obj, .stl, .ply, ...). Ziehen Sie sie von hier in eine Ansicht, oder nehmen Sie eines mit Doppelklick in die Hand.</translation>
    </message>
</context>
<context>
    <name>trivet::edit::AssetDock</name>
    <message>
        <source>Models</source>
        <translation>Modelle</translation>
    </message>
</context>
<context>
    <name>trivet::edit::BookmarkMenu</name>
    <message>
        <source>&amp;Bookmarks</source>
        <translation>&amp;Lesezeichen</translation>
    </message>
    <message>
        <source>View &amp;%1</source>
        <translation>Ansicht &amp;%1</translation>
    </message>
    <message>
        <source>Show the view stored as %1</source>
        <translation>Die als %1 gemerkte Ansicht zeigen</translation>
    </message>
    <message>
        <source>Store as view %1</source>
        <translation>Als Ansicht %1 merken</translation>
    </message>
    <message>
        <source>Store the view under the mouse as %1</source>
        <translation>Die Ansicht unter der Maus als %1 merken</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>Three-view</source>
        <translation>Dreitafel</translation>
    </message>
    <message>
        <source>Constraint</source>
        <translation>Zwangsbedingung</translation>
    </message>
    <message>
        <source>View &amp;%1: %2</source>
        <translation>Ansicht &amp;%1: %2</translation>
    </message>
</context>
<context>
    <name>trivet::edit::ControlWindow</name>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Click a step to go back or forward to it</source>
        <translation>Ein Klick geht zu diesem Schritt zurück oder vor</translation>
    </message>
    <message>
        <source>Search objects (/)</source>
        <translation>Objekte suchen (/)</translation>
    </message>
    <message>
        <source>Part of a name; Return selects all objects that are found</source>
        <translation>Teil eines Namens; die Eingabetaste wählt alle gefundenen Objekte aus</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Demos</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
</context>
<context>
    <name>trivet::edit::DepthImages</name>
    <message>
        <source>No other object is in the way of this motion.</source>
        <translation>Dieser Bewegung ist kein anderes Objekt im Weg.</translation>
    </message>
    <message>
        <source>Drag an object, or move the mouse with Put: the depths of its motion appear here.</source>
        <translation>Ein Objekt ziehen oder mit „Ablegen“ die Maus bewegen: hier erscheinen die Tiefen seiner Bewegung.</translation>
    </message>
    <message>
        <source>Moving front</source>
        <translation>Bewegte Front</translation>
    </message>
    <message>
        <source>Fixed front</source>
        <translation>Feste Front</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Abstand</translation>
    </message>
</context>
<context>
    <name>trivet::edit::Document</name>
    <message>
        <source>new scene</source>
        <translation>neue Szene</translation>
    </message>
    <message>
        <source>open &quot;%1&quot;</source>
        <translation>öffnen: „%1“</translation>
    </message>
    <message>
        <source>demo &quot;%1&quot;</source>
        <translation>Demo „%1“</translation>
    </message>
    <message>
        <source>save</source>
        <translation>sichern</translation>
    </message>
    <message>
        <source>save &quot;%1&quot;</source>
        <translation>sichern: „%1“</translation>
    </message>
    <message>
        <source>export &quot;%1&quot;</source>
        <translation>exportieren: „%1“</translation>
    </message>
    <message>
        <source>close</source>
        <translation>schließen</translation>
    </message>
    <message>
        <source>restore</source>
        <translation>wiederherstellen</translation>
    </message>
    <message>
        <source>scale &quot;%1&quot;</source>
        <translation>skalieren „%1“</translation>
    </message>
    <message>
        <source>import &quot;%1&quot;</source>
        <translation>importieren: „%1“</translation>
    </message>
    <message>
        <source>undo</source>
        <translation>rückgängig</translation>
    </message>
    <message>
        <source>redo</source>
        <translation>wiederholen</translation>
    </message>
    <message>
        <source>history</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>arrange</source>
        <translation>anordnen</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>ziehen</translation>
    </message>
    <message>
        <source>%1 was cancelled</source>
        <translation>%1: abgebrochen</translation>
    </message>
    <message>
        <source>%1: not enough memory</source>
        <translation>%1: zu wenig Speicher</translation>
    </message>
    <message>
        <source>arrange: the scene has changed since the arrangement was found; look for another</source>
        <translation>anordnen: die Szene hat sich geändert, seit die Anordnung gefunden wurde; eine andere suchen</translation>
    </message>
    <message>
        <source>%1: %2 of %3; the others were refused, the first: %4</source>
        <translation>%1: %2 von %3; die anderen wurden abgelehnt, das erste: %4</translation>
    </message>
    <message>
        <source>%1: stopped after %2 of %3, which stay</source>
        <translation>%1: nach %2 von %3 angehalten; diese bleiben</translation>
    </message>
    <message>
        <source>%1: no object passes through another, and all are at rest</source>
        <translation>%1: kein Objekt durchdringt ein anderes, und alle sind in Ruhe</translation>
    </message>
</context>
<context>
    <name>trivet::edit::FormDialog</name>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>trivet::edit::ImportDialog</name>
    <message>
        <source>Fixed: stays where it is put, and supports any load</source>
        <translation>Fest: bleibt, wo es abgelegt wird, und trägt jede Last</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>other</source>
        <translation>andere</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <translation>Modelle (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message numerus="yes">
        <source>Import %n models</source>
        <translation>
            <numerusform>%n Modell importieren</numerusform>
            <numerusform>%n Modelle importieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Metres per unit</source>
        <translation>Meter je Einheit</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>likely</source>
        <translation>wohl</translation>
    </message>
    <message>
        <source>All: unit</source>
        <translation>Alle: Einheit</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>as stated</source>
        <translation>wie angegeben</translation>
    </message>
    <message>
        <source>likely %1</source>
        <translation>wohl %1</translation>
    </message>
    <message>
        <source>as stated: %1</source>
        <translation>wie angegeben: %1</translation>
    </message>
    <message>
        <source>Imported models are not placed yet; click where to put them.</source>
        <translation>Importierte Modelle stehen noch nirgends; klicken, wohin sie sollen.</translation>
    </message>
    <message>
        <source>Reading: %1 of %2 files</source>
        <translation>Gelesen: %1 von %2 Dateien</translation>
    </message>
    <message numerus="yes">
        <source>%n files cannot be read and are left out.</source>
        <translation>
            <numerusform>%n Datei ist nicht lesbar und bleibt weg.</numerusform>
            <numerusform>%n Dateien sind nicht lesbar und bleiben weg.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trivet::edit::MainWindow</name>
    <message>
        <source>New &amp;collection</source>
        <translation>Neue Samm&amp;lung</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Collection: the selected objects under one name, to be shown and selected together</source>
        <translation>Sammlung: die ausgewählten Objekte unter einem Namen, gemeinsam gezeigt und ausgewählt</translation>
    </message>
    <message>
        <source>Take out of its collection</source>
        <translation>Aus der Sammlung nehmen</translation>
    </message>
    <message>
        <source>Take the selected objects out of their collections</source>
        <translation>Die ausgewählten Objekte aus ihren Sammlungen nehmen</translation>
    </message>
    <message>
        <source>collection</source>
        <translation>Sammlung</translation>
    </message>
    <message>
        <source>lock</source>
        <translation>sperren</translation>
    </message>
    <message>
        <source>unlock</source>
        <translation>entsperren</translation>
    </message>
    <message>
        <source>fix</source>
        <translation>befestigen</translation>
    </message>
    <message>
        <source>unfix</source>
        <translation>lösen</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>group</source>
        <translation>gruppieren</translation>
    </message>
    <message>
        <source>ungroup</source>
        <translation>Gruppe auflösen</translation>
    </message>
    <message>
        <source>%1, for simulators</source>
        <translation>%1, für Simulatoren</translation>
    </message>
    <message>
        <source>%1, a table of poses</source>
        <translation>%1, Tabelle der Lagen</translation>
    </message>
    <message>
        <source>All formats</source>
        <translation>Alle Formate</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Änderungen an %1 speichern?</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Scenes and layouts (*.glb *.json);;All files (*)</source>
        <translation>Szenen und Layouts (*.glb *.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Scene (*.glb);;Layout (*.json)</source>
        <translation>Szene (*.glb);;Layout (*.json)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Exported: %1</source>
        <translation>Exportiert: %1</translation>
    </message>
    <message>
        <source>Import models</source>
        <translation>Modelle importieren</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>%1: there is none to put</source>
        <translation>%1: es gibt keines abzulegen</translation>
    </message>
    <message>
        <source>Array: first put the object</source>
        <translation>Reihe: das Objekt zuerst ablegen</translation>
    </message>
    <message>
        <source>array</source>
        <translation>Reihe</translation>
    </message>
    <message>
        <source>Put all: every object is placed</source>
        <translation>Alle ablegen: jedes Objekt ist abgelegt</translation>
    </message>
    <message>
        <source>put all</source>
        <translation>alle ablegen</translation>
    </message>
    <message>
        <source>scatter</source>
        <translation>verstreuen</translation>
    </message>
    <message>
        <source>Align: select two objects or more</source>
        <translation>Ausrichten: zwei oder mehr Objekte auswählen</translation>
    </message>
    <message>
        <source>align</source>
        <translation>ausrichten</translation>
    </message>
    <message>
        <source>Replace: select the objects, and last the one whose copies take their places</source>
        <translation>Ersetzen: die Objekte auswählen, zuletzt das, dessen Kopien an ihre Stelle treten</translation>
    </message>
    <message>
        <source>replace</source>
        <translation>ersetzen</translation>
    </message>
    <message>
        <source>&amp;Array…</source>
        <translation>&amp;Reihe…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>Array: copies in a line, a grid or a circle</source>
        <translation>Reihe: Kopien auf einer Linie, einem Gitter oder einem Kreis</translation>
    </message>
    <message>
        <source>&amp;Scatter…</source>
        <translation>Ver&amp;streuen…</translation>
    </message>
    <message>
        <source>Scatter: copies at free places of a support</source>
        <translation>Verstreuen: Kopien an freien Stellen einer Unterlage</translation>
    </message>
    <message>
        <source>Put a&amp;ll…</source>
        <translation>A&amp;lle ablegen…</translation>
    </message>
    <message>
        <source>Put all objects that are not placed yet</source>
        <translation>Alle Objekte ablegen, die es noch nicht sind</translation>
    </message>
    <message>
        <source>Al&amp;ign…</source>
        <translation>A&amp;usrichten…</translation>
    </message>
    <message>
        <source>Align the selected objects, or space them evenly</source>
        <translation>Ausgewählte Objekte ausrichten oder gleichmäßig verteilen</translation>
    </message>
    <message>
        <source>&amp;Replace by the last selected</source>
        <translation>Durch das &amp;zuletzt gewählte ersetzen</translation>
    </message>
    <message>
        <source>Replace the selected objects by copies of the one selected last</source>
        <translation>Die ausgewählten Objekte durch Kopien des zuletzt gewählten ersetzen</translation>
    </message>
    <message>
        <source>H&amp;ide</source>
        <translation>Aus&amp;blenden</translation>
    </message>
    <message>
        <source>Ctrl+H</source>
        <translation>Ctrl+H</translation>
    </message>
    <message>
        <source>Hide: not drawn; it stays in the scene</source>
        <translation>Ausblenden: nicht gezeichnet; es bleibt in der Szene</translation>
    </message>
    <message>
        <source>Sho&amp;w hidden</source>
        <translation>Ausgeblendete &amp;zeigen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>&amp;Not selectable</source>
        <translation>&amp;Nicht auswählbar</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Not selectable: clicks pass through it, but things can be put on it</source>
        <translation>Nicht auswählbar: Klicks gehen hindurch, aber man kann darauf ablegen</translation>
    </message>
    <message>
        <source>All s&amp;electable</source>
        <translation>Alle aus&amp;wählbar</translation>
    </message>
    <message>
        <source>Ctrl+Shift+K</source>
        <translation>Ctrl+Shift+K</translation>
    </message>
    <message>
        <source>Co&amp;lour</source>
        <translation>&amp;Farbe</translation>
    </message>
    <message>
        <source>As the model</source>
        <translation>Wie das Modell</translation>
    </message>
    <message>
        <source>A table in &amp;two minutes</source>
        <translation>Ein Tisch in &amp;zwei Minuten</translation>
    </message>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>&amp;Maus und Tasten</translation>
    </message>
    <message>
        <source>&amp;About Trivet</source>
        <translation>&amp;Über Trivet</translation>
    </message>
    <message>
        <source>About Trivet</source>
        <translation>Über Trivet</translation>
    </message>
    <message>
        <source>&lt;b&gt;Trivet %1&lt;/b&gt;&lt;p&gt;Lays out objects with geometric and physical constraints, after Shinya and Forgue (1995).&lt;/p&gt;&lt;p&gt;MIT licence. Pictures: %2&lt;/p&gt;</source>
        <translation>&lt;b&gt;Trivet %1&lt;/b&gt;&lt;p&gt;Ordnet Objekte mit geometrischen und physikalischen Bedingungen an, nach Shinya und Forgue (1995).&lt;/p&gt;&lt;p&gt;MIT-Lizenz. Bilder: %2&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>New scene: an empty floor</source>
        <translation>Neue Szene: ein leerer Boden</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a scene or a layout</source>
        <translation>Szene oder Layout öffnen</translation>
    </message>
    <message>
        <source>&amp;Import models…</source>
        <translation>Modelle &amp;importieren…</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Export for other programs, for simulators, or as a table</source>
        <translation>Exportieren für andere Programme, für Simulatoren oder als Tabelle</translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation>&amp;Bild…</translation>
    </message>
    <message>
        <source>Ctrl+P</source>
        <translation>Ctrl+P</translation>
    </message>
    <message>
        <source>Picture of the perspective view</source>
        <translation>Bild der perspektivischen Ansicht</translation>
    </message>
    <message>
        <source>Start pa&amp;ge</source>
        <translation>Startseit&amp;e</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Duplicate: add another object of the same model, not placed yet</source>
        <translation>Duplizieren: ein weiteres Objekt desselben Modells, noch nicht abgelegt</translation>
    </message>
    <message>
        <source>Rena&amp;me</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Alles auswählen</translation>
    </message>
    <message>
        <source>Searc&amp;h</source>
        <translation>Suc&amp;hen</translation>
    </message>
    <message>
        <source>/</source>
        <translation>/</translation>
    </message>
    <message>
        <source>Select &amp;none</source>
        <translation>&amp;Nichts auswählen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>Loc&amp;k</source>
        <translation>&amp;Sperren</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Lock: operations refuse to move it; it may still topple</source>
        <translation>Sperren: Operationen bewegen es nicht; umkippen kann es dennoch</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>Fi&amp;x</source>
        <translation>Be&amp;festigen</translation>
    </message>
    <message>
        <source>Ctrl+F</source>
        <translation>Ctrl+F</translation>
    </message>
    <message>
        <source>Fix: it never moves, and supports any load</source>
        <translation>Befestigen: es bewegt sich nie und trägt jede Last</translation>
    </message>
    <message>
        <source>Unfix</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Unfix: it can be moved again, with its loads</source>
        <translation>Lösen: es kann wieder bewegt werden, mit seinen Lasten</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>&amp;Gruppieren</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Group: its objects always move together</source>
        <translation>Gruppieren: ihre Objekte bewegen sich immer gemeinsam</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Gruppe auflösen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Auswählen</translation>
    </message>
    <message>
        <source>&amp;Put</source>
        <translation>Ab&amp;legen</translation>
    </message>
    <message>
        <source>Put: drop the object where you click, and let it settle</source>
        <translation>Ablegen: das Objekt fällt, wo geklickt wird, und kommt zur Ruhe</translation>
    </message>
    <message>
        <source>Pus&amp;h</source>
        <translation>S&amp;chieben</translation>
    </message>
    <message>
        <source>Push: move the object along the surface it lies on</source>
        <translation>Schieben: das Objekt auf seiner Unterlage bewegen</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>&amp;Wenden</translation>
    </message>
    <message>
        <source>Turn: about a contact&apos;s normal, edge or point</source>
        <translation>Wenden: um Normale, Kante oder Punkt eines Kontakts</translation>
    </message>
    <message>
        <source>Pick &amp;up</source>
        <translation>Auf&amp;nehmen</translation>
    </message>
    <message>
        <source>Pick up: move the object away from its support</source>
        <translation>Aufnehmen: das Objekt von seiner Unterlage heben</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Verschieben</translation>
    </message>
    <message>
        <source>Move: translate the object by handles</source>
        <translation>Verschieben: das Objekt an Griffen bewegen</translation>
    </message>
    <message>
        <source>&amp;Rotate</source>
        <translation>&amp;Drehen</translation>
    </message>
    <message>
        <source>Rotate: turn the object by handles</source>
        <translation>Drehen: das Objekt an Griffen drehen</translation>
    </message>
    <message>
        <source>Put at the mouse &amp;position</source>
        <translation>An der &amp;Mausposition ablegen</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>Put: drop the active object at the mouse position</source>
        <translation>Ablegen: das aktive Objekt an der Mausposition fallen lassen</translation>
    </message>
    <message>
        <source>Take the &amp;next object</source>
        <translation>Nä&amp;chstes Objekt nehmen</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Put: take the next object that is not placed yet</source>
        <translation>Ablegen: das nächste noch nicht abgelegte Objekt nehmen</translation>
    </message>
    <message>
        <source>Pick up &amp;now</source>
        <translation>&amp;Jetzt aufnehmen</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>Pick up the selected object by the distance in the operation panel</source>
        <translation>Das ausgewählte Objekt um den Abstand im Reiter „Operation“ heben</translation>
    </message>
    <message>
        <source>&amp;Frame selected</source>
        <translation>&amp;Auswahl einpassen</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Frame &amp;all</source>
        <translation>A&amp;lles einpassen</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>&amp;Constraint window follows the contact</source>
        <translation>&amp;Zwangsfenster folgt dem Kontakt</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>&amp;Maximise window</source>
        <translation>Fenster &amp;maximieren</translation>
    </message>
    <message>
        <source>Ctrl+Space</source>
        <translation>Ctrl+Space</translation>
    </message>
    <message>
        <source>Maximise the window under the mouse, and restore it</source>
        <translation>Das Fenster unter der Maus maximieren und wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>View direction of the window under the mouse</source>
        <translation>Blickrichtung des Fensters unter der Maus</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>Von der Seite</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>From behind</source>
        <translation>Von hinten</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>&amp;Side</source>
        <translation>&amp;Seite</translation>
    </message>
    <message>
        <source>Fr&amp;ont</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>View direction of the three-view window</source>
        <translation>Blickrichtung des Dreitafelfensters</translation>
    </message>
    <message>
        <source>S&amp;hadows</source>
        <translation>Sc&amp;hatten</translation>
    </message>
    <message>
        <source>C&amp;ontacts of the active object</source>
        <translation>K&amp;ontakte des aktiven Objekts</translation>
    </message>
    <message>
        <source>&amp;Watch settling</source>
        <translation>&amp;Zur-Ruhe-Kommen zeigen</translation>
    </message>
    <message>
        <source>&amp;z-lists of the motion</source>
        <translation>&amp;z-Listen der Bewegung</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>z-lists: depths along the motion of what is dragged or put</source>
        <translation>z-Listen: Tiefen entlang der Bewegung dessen, was gezogen oder abgelegt wird</translation>
    </message>
    <message>
        <source>&amp;Models</source>
        <translation>&amp;Modelle</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Models: folders of models, to drag into the views</source>
        <translation>Modelle: Ordner mit Modellen, die in die Ansichten gezogen werden</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>&amp;Dunkle Darstellung</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open &amp;demo</source>
        <translation>&amp;Beispiel öffnen</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Object</source>
        <translation>&amp;Objekt</translation>
    </message>
    <message>
        <source>&amp;Many</source>
        <translation>&amp;Viele</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>P&amp;aint</source>
        <translation>&amp;Malen</translation>
    </message>
    <message>
        <source>Paint: drag over a surface to set down copies along the stroke</source>
        <translation>Malen: über eine Fläche ziehen, um Kopien entlang des Strichs abzulegen</translation>
    </message>
    <message>
        <source>Ne&amp;xt contact</source>
        <translation>Nä&amp;chster Kontakt</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>The next contact of the active object: the constraint window looks along it, and Push goes along it, walls included</source>
        <translation>Der nächste Kontakt des aktiven Objekts: das Zwangsfenster blickt daran entlang, und Schieben folgt ihm, auch an Wänden</translation>
    </message>
    <message>
        <source>&amp;Section: cut away what is in front</source>
        <translation>&amp;Schnitt: wegschneiden, was davor steht</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Section: the window under the mouse cuts away what stands in front of the active object; Control and the wheel move the plane</source>
        <translation>Schnitt: das Fenster unter der Maus schneidet weg, was vor dem aktiven Objekt steht; Strg und das Rad verschieben die Ebene</translation>
    </message>
    <message>
        <source>&amp;Arrange…</source>
        <translation>Anor&amp;dnen…</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Arrange: constraints between objects, and scenes that meet them</source>
        <translation>Anordnen: Bedingungen zwischen Objekten, und Szenen, die sie erfüllen</translation>
    </message>
    <message>
        <source>take out of its collection</source>
        <translation>aus der Sammlung nehmen</translation>
    </message>
    <message>
        <source>new collection</source>
        <translation>neue Sammlung</translation>
    </message>
    <message>
        <source>duplicate</source>
        <translation>verdoppeln</translation>
    </message>
    <message numerus="yes">
        <source>%n models were not imported: %1</source>
        <translation>
            <numerusform>%n Modell wurde nicht importiert: %1</numerusform>
            <numerusform>%n Modelle wurden nicht importiert: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>hide</source>
        <translation>ausblenden</translation>
    </message>
    <message>
        <source>show hidden</source>
        <translation>Ausgeblendetes zeigen</translation>
    </message>
    <message>
        <source>not selectable</source>
        <translation>nicht wählbar</translation>
    </message>
    <message>
        <source>all selectable</source>
        <translation>alle wählbar</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>&amp;Quick actions…</source>
        <translation>Schnell&amp;aktionen…</translation>
    </message>
    <message>
        <source>Quick actions: find an action by words</source>
        <translation>Schnellaktionen: eine Aktion nach Wörtern finden</translation>
    </message>
    <message>
        <source>Select and move: drag an object, click it, or draw a box</source>
        <translation>Auswählen und Bewegen: ein Objekt ziehen, anklicken, oder einen Rahmen ziehen</translation>
    </message>
    <message>
        <source>Next wa&amp;y to lie</source>
        <translation>&amp;Nächste Lage</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Lift the object, lay it as it can lie next, and let it settle</source>
        <translation>Das Objekt heben, in seine nächste Lage bringen und zur Ruhe kommen lassen</translation>
    </message>
    <message>
        <source>Lay on its s&amp;ide</source>
        <translation>Auf die Se&amp;ite legen</translation>
    </message>
    <message>
        <source>Lift the object, lay it on its side, and let it settle</source>
        <translation>Das Objekt heben, auf die Seite legen und zur Ruhe kommen lassen</translation>
    </message>
    <message>
        <source>Stand upri&amp;ght</source>
        <translation>Aufr&amp;echt stellen</translation>
    </message>
    <message>
        <source>Lift the object, stand it upright, and let it settle</source>
        <translation>Das Objekt heben, aufrecht stellen und zur Ruhe kommen lassen</translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation>Nach &amp;links drehen</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>Turn about the vertical by a step, seen from above to the left</source>
        <translation>Um die Senkrechte einen Schritt drehen, von oben gesehen nach links</translation>
    </message>
    <message>
        <source>Turn ri&amp;ght</source>
        <translation>Nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>Turn about the vertical by a step, seen from above to the right</source>
        <translation>Um die Senkrechte einen Schritt drehen, von oben gesehen nach rechts</translation>
    </message>
    <message>
        <source>Shift+Space</source>
        <translation>Shift+Space</translation>
    </message>
    <message>
        <source>L&amp;ean against the last selected</source>
        <translation>An das z&amp;uletzt ausgewählte lehnen</translation>
    </message>
    <message>
        <source>Lean: select an object that stands, then what it leans on</source>
        <translation>Lehnen: erst ein stehendes Objekt auswählen, dann das, woran es lehnt</translation>
    </message>
    <message>
        <source>Tilt the object until it touches the one selected last, and let it go</source>
        <translation>Das Objekt kippen, bis es das zuletzt ausgewählte berührt, und loslassen</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>Alt+L</source>
        <translation>Alt+L</translation>
    </message>
    <message>
        <source>Alt+U</source>
        <translation>Alt+U</translation>
    </message>
    <message>
        <source>&amp;Drape</source>
        <translation>&amp;Drapieren</translation>
    </message>
    <message>
        <source>Drape: let a cloth, a paper or a cable come down where you click</source>
        <translation>Drapieren: ein Tuch, ein Papier oder ein Kabel herabfallen lassen, wo Sie klicken</translation>
    </message>
    <message>
        <source>&amp;Mend</source>
        <translation>In &amp;Ordnung bringen</translation>
    </message>
    <message>
        <source>Mend: move what interpenetrates or floats as little as possible, so that everything rests on what it was meant to rest on; of several selected objects, these alone</source>
        <translation>In Ordnung bringen: was sich durchdringt oder schwebt, so wenig wie möglich bewegen, damit alles auf dem ruht, worauf es gedacht war; sind mehrere Objekte gewählt, nur diese</translation>
    </message>
    <message>
        <source>Se&amp;ttle</source>
        <translation>Zur &amp;Ruhe bringen</translation>
    </message>
    <message>
        <source>Settle: let what floats or is sunk come to rest; of several selected objects, these alone</source>
        <translation>Zur Ruhe bringen: was schwebt oder eingesunken ist, zur Ruhe kommen lassen; sind mehrere Objekte gewählt, nur diese</translation>
    </message>
</context>
<context>
    <name>trivet::edit::MessageBar</name>
    <message>
        <source>Close (Escape)</source>
        <translation>Schließen (Escape)</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Abgelehnt</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Attention</source>
        <translation>Achtung</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
</context>
<context>
    <name>trivet::edit::OperationPanel</name>
    <message>
        <source>Settle objects left without support</source>
        <translation>Objekte ohne Unterlage ablegen</translation>
    </message>
    <message>
        <source>Objects that lose their support settle too; otherwise they are marked</source>
        <translation>Objekte, die ihre Unterlage verlieren, kommen auch zur Ruhe; sonst werden sie markiert</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Apply to the active object with these numbers; other selected objects move along</source>
        <translation>Mit diesen Zahlen auf das aktive Objekt anwenden; andere ausgewählte bewegen sich mit</translation>
    </message>
    <message>
        <source>From a position, the object falls; on another object, the free place nearest to x, y is searched</source>
        <translation>Von einer Position fällt das Objekt; auf einem anderen wird die freie Stelle gesucht, die x, y am nächsten ist</translation>
    </message>
    <message>
        <source>Onto</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Gedreht</translation>
    </message>
    <message>
        <source>About the vertical axis</source>
        <translation>Um die senkrechte Achse</translation>
    </message>
    <message>
        <source>Keep away</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Distance from everything but its support</source>
        <translation>Abstand von allem außer der Unterlage</translation>
    </message>
    <message>
        <source>Drop height</source>
        <translation>Fallhöhe</translation>
    </message>
    <message>
        <source>For the mouse: above the highest point below the object</source>
        <translation>Für die Maus: über dem höchsten Punkt unter dem Objekt</translation>
    </message>
    <message>
        <source>Then take the next object</source>
        <translation>Dann das nächste Objekt</translation>
    </message>
    <message>
        <source>After a click that put one: the next object that is not placed yet (or press N)</source>
        <translation>Nach einem Klick, der eines ablegte: das nächste noch nicht abgelegte Objekt (oder Taste N)</translation>
    </message>
    <message>
        <source>Put</source>
        <translation>Ablegen</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Seen from above, from x towards y</source>
        <translation>Von oben gesehen, von x nach y</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Step up</source>
        <translation>Stufe hinauf</translation>
    </message>
    <message>
        <source>Higher steps stop the object</source>
        <translation>Höhere Stufen halten das Objekt auf</translation>
    </message>
    <message>
        <source>Step down</source>
        <translation>Stufe hinab</translation>
    </message>
    <message>
        <source>Deeper edges stop the object</source>
        <translation>Tiefere Kanten halten das Objekt auf</translation>
    </message>
    <message>
        <source>Slide along walls</source>
        <translation>An Wänden entlang</translation>
    </message>
    <message>
        <source>Otherwise walls stop the object</source>
        <translation>Sonst halten Wände das Objekt auf</translation>
    </message>
    <message>
        <source>Settle at the end</source>
        <translation>Am Ende zur Ruhe</translation>
    </message>
    <message>
        <source>Otherwise the object is held</source>
        <translation>Sonst wird das Objekt gehalten</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Schieben</translation>
    </message>
    <message>
        <source>the contact&apos;s normal</source>
        <translation>die Normale des Kontakts</translation>
    </message>
    <message>
        <source>an edge of the contact</source>
        <translation>eine Kante des Kontakts</translation>
    </message>
    <message>
        <source>a contact point</source>
        <translation>einen Kontaktpunkt</translation>
    </message>
    <message>
        <source>Click a contact point, edge or area in a view to choose it</source>
        <translation>Kontaktpunkt, -kante oder -fläche in einer Ansicht anklicken, um sie zu wählen</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Um</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Wenden</translation>
    </message>
    <message>
        <source>Along the contact&apos;s normal</source>
        <translation>Entlang der Normalen des Kontakts</translation>
    </message>
    <message>
        <source>Pick up</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Ignore collisions</source>
        <translation>Kollisionen übergehen</translation>
    </message>
    <message>
        <source>As in a modeller; interpenetrating objects are marked until resolved</source>
        <translation>Wie in einem Modellierer; durchdringende Objekte sind markiert, bis es behoben ist</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>About the centre of mass</source>
        <translation>Um den Schwerpunkt</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>the surface below</source>
        <translation>die Fläche darunter</translation>
    </message>
    <message>
        <source>a free place on the floor</source>
        <translation>eine freie Stelle am Boden</translation>
    </message>
    <message>
        <source>Steps in proportion to the object</source>
        <translation>Stufen im Verhältnis zum Objekt</translation>
    </message>
    <message>
        <source>Otherwise in millimetres. Steps are measured across the surface</source>
        <translation>Sonst in Millimetern. Stufen werden quer zur Fläche gemessen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Largest step in parts of the object&apos;s size; higher steps and deeper edges stop it</source>
        <translation>Größte Stufe als Anteil der Größe des Objekts; höhere Stufen und tiefere Kanten halten es auf</translation>
    </message>
    <message>
        <source>Drag over a surface: copies of the selected objects, in turn, along the stroke.</source>
        <translation>Über eine Fläche ziehen: Kopien der ausgewählten Objekte, reihum, entlang des Strichs.</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Between the middles of the copies; 0: side by side</source>
        <translation>Zwischen den Mitten der Kopien; 0: dicht an dicht</translation>
    </message>
    <message>
        <source>side by side</source>
        <translation>dicht an dicht</translation>
    </message>
    <message>
        <source>Random turns</source>
        <translation>Zufällig drehen</translation>
    </message>
    <message>
        <source>Each copy is turned about the vertical axis</source>
        <translation>Jede Kopie wird um die Senkrechte gedreht</translation>
    </message>
    <message>
        <source>Seed of the turns: the same strokes give the same scene</source>
        <translation>Startwert der Drehungen: gleiche Striche ergeben dieselbe Szene</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Above the surface under the stroke</source>
        <translation>Über der Fläche unter dem Strich</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>For the mouse, while Control is held or the magnet is on</source>
        <translation>Für die Maus, solange Strg gehalten oder der Magnet an ist</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Drag an object to move it: it slides, climbs onto what is under the mouse, and settles. Wheel: turn; L: next way to lie; Shift: lift; Control: snap. Click selects, Shift-click adds; drag from the ground to select with a box.</source>
        <translation>Ein Objekt ziehen: es gleitet, steigt auf das, was unter der Maus ist, und kommt zur Ruhe. Rad: drehen; L: nächste Lage; Umschalt: heben; Strg: einrasten. Klick wählt aus, mit Umschalt dazu; vom Boden aus gezogen wählt ein Rahmen.</translation>
    </message>
    <message>
        <source>Lift, turn and settle</source>
        <translation>Heben, drehen und zur Ruhe kommen lassen</translation>
    </message>
    <message>
        <source>For the mouse: otherwise the object turns where it is, and stops at collisions</source>
        <translation>Für die Maus: sonst dreht sich das Objekt, wo es ist, und hält an Hindernissen</translation>
    </message>
    <message>
        <source>Pour a pile</source>
        <translation>Haufen schütten</translation>
    </message>
    <message>
        <source>While the button is down, copies fall onto each other under the mouse</source>
        <translation>Solange die Taste gedrückt ist, fallen unter der Maus Kopien aufeinander</translation>
    </message>
    <message>
        <source> a second</source>
        <translation> je Sekunde</translation>
    </message>
    <message>
        <source>Copies of a pile, while the button is down</source>
        <translation>Kopien eines Haufens, solange die Taste gedrückt ist</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Menge</translation>
    </message>
    <message>
        <source>Cotton</source>
        <translation>Baumwolle</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Filz</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Towel</source>
        <translation>Handtuch</translation>
    </message>
    <message>
        <source>Wool</source>
        <translation>Wolle</translation>
    </message>
    <message>
        <source>Cable</source>
        <translation>Kabel</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Along the weft</source>
        <translation>Entlang des Schusses</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Along the warp</source>
        <translation>Entlang der Kette</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Largest side: small ones show small folds, and take longer</source>
        <translation>Größte Seite: Kleine Zellen zeigen kleine Falten und dauern länger</translation>
    </message>
    <message>
        <source>a 40th of the length</source>
        <translation>ein Vierzigstel der Länge</translation>
    </message>
    <message>
        <source>Slack</source>
        <translation>Durchhang</translation>
    </message>
    <message>
        <source>By how much a cable is longer than its way</source>
        <translation>Um so viel ist ein Kabel länger als sein Weg</translation>
    </message>
    <message>
        <source>Above the highest point below the sheet</source>
        <translation>Über dem höchsten Punkt unter dem Tuch</translation>
    </message>
    <message>
        <source>Drape</source>
        <translation>Drapieren</translation>
    </message>
</context>
<context>
    <name>trivet::edit::Outliner</name>
    <message>
        <source>Objects with their loads, and collections. Double click to frame an object, or to put one that is not placed yet; drag objects into a collection</source>
        <translation>Objekte mit ihren Lasten, und Sammlungen. Doppelklick passt ein Objekt ein oder legt eines ab, das es noch nicht ist; Objekte in eine Sammlung ziehen</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>ausgeblendet</translation>
    </message>
    <message>
        <source>not selectable</source>
        <translation>nicht auswählbar</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Not placed yet</source>
        <translation>Noch nicht abgelegt</translation>
    </message>
    <message>
        <source>Select its objects</source>
        <translation>Ihre Objekte auswählen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Selectable</source>
        <translation>Auswählbar</translation>
    </message>
    <message>
        <source>Not selectable</source>
        <translation>Nicht auswählbar</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Dissolve; its objects stay</source>
        <translation>Auflösen; ihre Objekte bleiben</translation>
    </message>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n Objekt</numerusform>
            <numerusform>%n Objekte</numerusform>
        </translation>
    </message>
    <message>
        <source>change of a collection</source>
        <translation>Sammlung ändern</translation>
    </message>
    <message>
        <source>lock</source>
        <translation>sperren</translation>
    </message>
    <message>
        <source>unlock</source>
        <translation>entsperren</translation>
    </message>
</context>
<context>
    <name>trivet::edit::PictureJob</name>
    <message>
        <source>Picture written: %1</source>
        <translation>Bild geschrieben: %1</translation>
    </message>
</context>
<context>
    <name>trivet::edit::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Automatic: the fastest here</source>
        <translation>Automatisch: das Schnellste hier</translation>
    </message>
    <message>
        <source>BVHs</source>
        <translation>Boxbäume</translation>
    </message>
    <message>
        <source>z-lists in software</source>
        <translation>z-Listen in Software</translation>
    </message>
    <message>
        <source>z-lists on the graphics card</source>
        <translation>z-Listen auf der Grafikkarte</translation>
    </message>
    <message>
        <source>Automatic: the faster one</source>
        <translation>Automatisch: das Schnellere</translation>
    </message>
    <message>
        <source>Framebuffers</source>
        <translation>Framebuffer</translation>
    </message>
    <message>
        <source>Compute shaders</source>
        <translation>Compute-Shader</translation>
    </message>
    <message>
        <source>Method that finds what stops a motion. Results are the same with all of them, to the bit.</source>
        <translation>Verfahren, das findet, was eine Bewegung aufhält. Die Ergebnisse sind bei allen bitgleich.</translation>
    </message>
    <message>
        <source>Collision detection</source>
        <translation>Kollisionserkennung</translation>
    </message>
    <message>
        <source>On the graphics card by</source>
        <translation>Auf der Grafikkarte durch</translation>
    </message>
    <message>
        <source>Answering now: %1; previews: %2</source>
        <translation>Jetzt antwortet: %1; Vorschau: %2</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>From the next start on</source>
        <translation>Ab dem nächsten Start</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Steps of drags while the magnet or Control is on.</source>
        <translation>Schritte beim Ziehen, solange der Magnet an oder Strg gedrückt ist.</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Winkel</translation>
    </message>
</context>
<context>
    <name>trivet::edit::Properties</name>
    <message>
        <source>floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>%1: %2 (%3)</source>
        <translation>%1: %2 (%3)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>surface, %1 m²</source>
        <translation>Oberfläche, %1 m²</translation>
    </message>
    <message>
        <source>convex hull, %1 litres</source>
        <translation>konvexe Hülle, %1 Liter</translation>
    </message>
    <message>
        <source>volume, %1 litres</source>
        <translation>Volumen, %1 Liter</translation>
    </message>
    <message>
        <source>Select an object to see its pose, its contacts, and how firmly it rests.</source>
        <translation>Ein Objekt auswählen, um Lage, Kontakte und Standfestigkeit zu sehen.</translation>
    </message>
    <message>
        <source> kg/m³</source>
        <translation> kg/m³</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>x, y, z in metres; a number typed here puts the object exactly there, without settling</source>
        <translation>x, y, z in Metern; eine Zahl hier setzt das Objekt genau dorthin, ohne dass es fällt</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Degrees about x, then y, then z; a number typed here turns the object exactly so</source>
        <translation>Grad um x, dann y, dann z; eine Zahl hier dreht das Objekt genau so</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Metres per unit of the model; with another number it is put anew in its place</source>
        <translation>Meter je Einheit des Modells; mit einer anderen Zahl wird es an seiner Stelle neu abgelegt</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>A preset, or the numbers below</source>
        <translation>Eine Vorgabe oder die Zahlen darunter</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Coulomb coefficient; of two surfaces in contact the smaller one holds</source>
        <translation>Coulomb-Beiwert; bei zwei Flächen gilt der kleinere</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>For weights, and for simulators</source>
        <translation>Für Gewichte und Simulatoren</translation>
    </message>
    <message>
        <source>Restitution</source>
        <translation>Stoßzahl</translation>
    </message>
    <message>
        <source>For simulators: nothing bounces here</source>
        <translation>Für Simulatoren: hier prallt nichts ab</translation>
    </message>
    <message>
        <source>  and %1 more</source>
        <translation>  und %1 weitere</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>To tipping</source>
        <translation>Bis zum Kippen</translation>
    </message>
    <message>
        <source>Distance of the centre of mass inside the support polygon, seen from above; negative: outside</source>
        <translation>Abstand des Schwerpunkts im Stützpolygon, von oben gesehen; negativ: außerhalb</translation>
    </message>
    <message>
        <source>Least friction</source>
        <translation>Kleinste Reibung</translation>
    </message>
    <message>
        <source>no coefficient holds it</source>
        <translation>kein Beiwert hält es</translation>
    </message>
    <message>
        <source>Smallest Coulomb coefficient that holds the object</source>
        <translation>Kleinster Coulomb-Beiwert, der das Objekt hält</translation>
    </message>
    <message>
        <source>As a whole</source>
        <translation>Als Ganzes</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Objects are of uniform density</source>
        <translation>Objekte haben gleichmäßige Dichte</translation>
    </message>
    <message>
        <source>Mass by</source>
        <translation>Masse nach</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>Berührt</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Property of the model&apos;s file; with another one the object is put anew</source>
        <translation>Eigenschaft der Modelldatei; mit einer anderen wird das Objekt neu hingestellt</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Oben-Achse</translation>
    </message>
    <message>
        <source>other</source>
        <translation>andere</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height of the object as it lies; another number scales it, and it settles with its loads</source>
        <translation>Höhe des Objekts, wie es liegt; eine andere Zahl skaliert es, und es kommt mit seinen Lasten zur Ruhe</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>With all that it touches, at the friction of the materials. Margin: how far all weights may shift sideways before it gives way: %1</source>
        <translation>Mit allem, was es berührt, bei der Reibung der Materialien. Spielraum: wie weit sich alle Gewichte seitlich verschieben dürfen, bevor es nachgibt: %1</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>Opens and closes it with all that lies in and on it, up to what is in the way</source>
        <translation>Öffnet und schließt es mit allem, was darin und darauf liegt, bis etwas im Weg ist</translation>
    </message>
</context>
<context>
    <name>trivet::edit::QuickActions</name>
    <message>
        <source>Quick actions</source>
        <translation>Schnellaktionen</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
</context>
<context>
    <name>trivet::edit::SceneView</name>
    <message>
        <source>Cannot draw: %1</source>
        <translation>Kann nicht zeichnen: %1</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Cut away in front of %1</source>
        <translation>Weggeschnitten vor %1</translation>
    </message>
    <message>
        <source>Cut away in front of the middle</source>
        <translation>Weggeschnitten vor der Mitte</translation>
    </message>
    <message>
        <source>Section: nothing is in the way</source>
        <translation>Schnitt: es ist nichts im Weg</translation>
    </message>
</context>
<context>
    <name>trivet::edit::SnapMenu</name>
    <message>
        <source>Sna&amp;p to</source>
        <translation>Einrasten &amp;an</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>&amp;Einrasten</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Snap: to corners, edges, faces, the grid and steps of angles; Control turns it over during a drag</source>
        <translation>Einrasten: an Ecken, Kanten, Flächen, Gitter und Winkelschritten; Strg kehrt es beim Ziehen um</translation>
    </message>
    <message>
        <source>&amp;Corners</source>
        <translation>&amp;Ecken</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>&amp;Kanten</translation>
    </message>
    <message>
        <source>&amp;Faces</source>
        <translation>&amp;Flächen</translation>
    </message>
    <message>
        <source>The &amp;grid</source>
        <translation>&amp;Gitter</translation>
    </message>
    <message>
        <source>While the magnet or Control is on</source>
        <translation>Solange der Magnet an oder Strg gedrückt ist</translation>
    </message>
    <message>
        <source>&amp;Steps…</source>
        <translation>&amp;Schritte…</translation>
    </message>
</context>
<context>
    <name>trivet::edit::StartPage</name>
    <message>
        <source>A breakfast table of 24 objects</source>
        <translation>Ein Frühstückstisch aus 24 Objekten</translation>
    </message>
    <message>
        <source>A tidy office of 16 objects</source>
        <translation>Ein aufgeräumtes Büro aus 16 Objekten</translation>
    </message>
    <message>
        <source>The same office, untidied, with 9 more objects</source>
        <translation>Dasselbe Büro, unordentlich, mit 9 weiteren Objekten</translation>
    </message>
    <message>
        <source>Lays out 3D objects without interpenetration, at rest.</source>
        <translation>Ordnet 3D-Objekte ohne Durchdringung und in Ruhe an.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Demos</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>New scene</source>
        <translation>Neue Szene</translation>
    </message>
    <message>
        <source>An empty floor</source>
        <translation>Ein leerer Boden</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>A scene (.glb) or a layout (.json)</source>
        <translation>Eine Szene (.glb) oder ein Layout (.json)</translation>
    </message>
    <message>
        <source>Import models…</source>
        <translation>Modelle importieren…</translation>
    </message>
    <message>
        <source>Any mesh; or drop files onto this window</source>
        <translation>Beliebige Netze; oder Dateien in dieses Fenster ziehen</translation>
    </message>
    <message>
        <source>A table in two minutes</source>
        <translation>Ein Tisch in zwei Minuten</translation>
    </message>
    <message>
        <source>A tutorial in eight steps</source>
        <translation>Eine Anleitung in acht Schritten</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt benutzt</translation>
    </message>
    <message>
        <source>A scene that was never saved</source>
        <translation>Eine nie gespeicherte Szene</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message numerus="yes">
        <source>%1 was not closed properly; %n steps, the last on %2</source>
        <translation>
            <numerusform>%1 wurde nicht richtig geschlossen; %n Schritt, der letzte am %2</numerusform>
            <numerusform>%1 wurde nicht richtig geschlossen; %n Schritte, der letzte am %2</numerusform>
        </translation>
    </message>
    <message>
        <source>A spoon and its saucer: the first steps</source>
        <translation>Ein Löffel und seine Untertasse: die ersten Schritte</translation>
    </message>
    <message>
        <source>A table laid for six</source>
        <translation>Ein Tisch, für sechs gedeckt</translation>
    </message>
    <message>
        <source>Demos that arrange themselves by constraints</source>
        <translation>Beispiele, die sich nach Bedingungen anordnen</translation>
    </message>
    <message>
        <source>The same on a smaller table</source>
        <translation>Dasselbe auf einem kleineren Tisch</translation>
    </message>
    <message>
        <source>Books in rows, a plant and a telephone</source>
        <translation>Bücher in Reihen, eine Pflanze und ein Telefon</translation>
    </message>
    <message>
        <source>A shop&apos;s shelf, filled row by row</source>
        <translation>Ein Ladenregal, Reihe um Reihe gefüllt</translation>
    </message>
    <message>
        <source>A desk with everything in view and in reach</source>
        <translation>Ein Schreibtisch, alles in Sicht und Reichweite</translation>
    </message>
    <message>
        <source>A workbench, tools and parts in their zones</source>
        <translation>Eine Werkbank, Werkzeuge und Teile in ihren Zonen</translation>
    </message>
    <message>
        <source>The same table with a cloth that came down</source>
        <translation>Derselbe Tisch mit einer Decke, die herabfiel</translation>
    </message>
    <message>
        <source>A coat over a chair, a paper at an edge, a lead</source>
        <translation>Ein Mantel über einem Stuhl, ein Papier an einer Kante, ein Kabel</translation>
    </message>
    <message>
        <source>A towel on a peg</source>
        <translation>Ein Handtuch an einem Haken</translation>
    </message>
    <message>
        <source>A kitchen unit with drawers and doors</source>
        <translation>Ein Küchenschrank mit Schubladen und Türen</translation>
    </message>
</context>
<context>
    <name>trivet::edit::StatusLine</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop the running operation; the scene stays unchanged (Escape)</source>
        <translation>Laufende Operation abbrechen; die Szene bleibt unverändert (Escape)</translation>
    </message>
    <message>
        <source>Stored as view %1: Alt+%1 shows it again</source>
        <translation>Als Ansicht %1 gemerkt: Alt+%1 zeigt sie wieder</translation>
    </message>
    <message>
        <source>In hand: %1</source>
        <translation>In der Hand: %1</translation>
    </message>
    <message>
        <source>Objects: %1</source>
        <translation>Objekte: %1</translation>
    </message>
    <message>
        <source>, selected: %1</source>
        <translation>, ausgewählt: %1</translation>
    </message>
    <message>
        <source> (last: %1)</source>
        <translation> (zuletzt: %1)</translation>
    </message>
    <message>
        <source>Detection: %1</source>
        <translation>Erkennung: %1</translation>
    </message>
    <message>
        <source>Collision detection. Moves: %1. Previews: %2. See Preferences.</source>
        <translation>Kollisionserkennung. Bewegungen: %1. Vorschau: %2. Siehe Einstellungen.</translation>
    </message>
    <message>
        <source>The scene as a whole, at the friction of the materials: %1</source>
        <translation>Die Szene als Ganzes, mit der Reibung der Materialien: %1</translation>
    </message>
</context>
<context>
    <name>trivet::edit::ViewFrame</name>
    <message>
        <source>Double click to maximise this window, and to restore it</source>
        <translation>Doppelklick maximiert dieses Fenster und stellt es wieder her</translation>
    </message>
</context>
<context>
    <name>trivet::edit::Workspace</name>
    <message>
        <source>Control</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>Three-view</source>
        <translation>Dreitafel</translation>
    </message>
    <message>
        <source>Constraint</source>
        <translation>Zwangsbedingung</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Cut away what hides the active object (X); Control and the wheel move the plane</source>
        <translation>Wegschneiden, was das aktive Objekt verdeckt (X); Strg und das Rad verschieben die Ebene</translation>
    </message>
    <message>
        <source>Cut away what stands in front of the active object (X); Control and the wheel move the plane</source>
        <translation>Wegschneiden, was vor dem aktiven Objekt steht (X); Strg und das Rad verschieben die Ebene</translation>
    </message>
    <message>
        <source>along the held edge of its contact with %1</source>
        <translation>entlang der gehaltenen Kante am Kontakt mit %1</translation>
    </message>
    <message>
        <source>along the normal at the held point of its contact with %1</source>
        <translation>entlang der Normalen im gehaltenen Punkt am Kontakt mit %1</translation>
    </message>
    <message>
        <source>along the normal of its contact with %1</source>
        <translation>entlang der Normalen des Kontakts mit %1</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>von oben</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>dem Boden</translation>
    </message>
</context>
<context>
    <name>trivet::edit::ZListDock</name>
    <message>
        <source>z-lists of the motion</source>
        <translation>z-Listen der Bewegung</translation>
    </message>
</context>
<context>
    <name>trivet::edit::ZListPanel</name>
    <message>
        <source>Moving face</source>
        <translation>Bewegte Fläche</translation>
    </message>
    <message>
        <source>Fixed face</source>
        <translation>Feste Fläche</translation>
    </message>
    <message>
        <source>Not before</source>
        <translation>Nicht vor</translation>
    </message>
</context>
<context>
    <name>units</name>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Fuß</translation>
    </message>
</context>
<context>
    <name>verdict</name>
    <message>
        <source> and %1 more</source>
        <translation> und %1 weitere</translation>
    </message>
    <message>
        <source>not known to stand: </source>
        <translation>ob sie steht, ist unbekannt: </translation>
    </message>
    <message>
        <source>tips towards</source>
        <translation>kippt nach</translation>
    </message>
    <message>
        <source>slides towards</source>
        <translation>rutscht nach</translation>
    </message>
    <message>
        <source>turns about the vertical</source>
        <translation>dreht sich um die Senkrechte</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>bewegt sich</translation>
    </message>
    <message>
        <source>sinks</source>
        <translation>sinkt</translation>
    </message>
    <message>
        <source>not supported: </source>
        <translation>ohne Halt: </translation>
    </message>
    <message>
        <source>barely stable</source>
        <translation>kaum stabil</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>stabil</translation>
    </message>
</context>
<context>
    <name>wishes</name>
    <message>
        <source>on</source>
        <translation>auf</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>right of</source>
        <translation>rechts von</translation>
    </message>
    <message>
        <source>left of</source>
        <translation>links von</translation>
    </message>
    <message>
        <source>in front of</source>
        <translation>vor</translation>
    </message>
    <message>
        <source>behind</source>
        <translation>hinter</translation>
    </message>
    <message>
        <source>with its back against</source>
        <translation>mit dem Rücken an</translation>
    </message>
    <message>
        <source>at the edge of</source>
        <translation>am Rand von</translation>
    </message>
    <message>
        <source>near</source>
        <translation>nahe bei</translation>
    </message>
    <message>
        <source>facing</source>
        <translation>zugewandt</translation>
    </message>
    <message>
        <source>facing away from</source>
        <translation>abgewandt von</translation>
    </message>
    <message>
        <source>turned as</source>
        <translation>gedreht wie</translation>
    </message>
    <message>
        <source>parallel to</source>
        <translation>parallel zu</translation>
    </message>
    <message>
        <source>perpendicular to</source>
        <translation>senkrecht zu</translation>
    </message>
    <message>
        <source>aligned with</source>
        <translation>ausgerichtet an</translation>
    </message>
    <message>
        <source>centred on</source>
        <translation>mittig auf</translation>
    </message>
    <message>
        <source>under</source>
        <translation>unter</translation>
    </message>
    <message>
        <source>in view of</source>
        <translation>im Blick von</translation>
    </message>
    <message>
        <source>in reach of</source>
        <translation>in Reichweite von</translation>
    </message>
    <message>
        <source>%1 placed, all hard constraints hold; the worst of the others is off by %2 tolerances</source>
        <translation>%1 hingestellt, alle harten Bedingungen sind erfüllt; der schlechteste der anderen weicht um %2 Toleranzen ab</translation>
    </message>
    <message>
        <source>%1 placed, all constraints hold</source>
        <translation>%1 hingestellt, alle Bedingungen sind erfüllt</translation>
    </message>
    <message>
        <source>, %1 to %2 cm</source>
        <translation>, %1 bis %2 cm</translation>
    </message>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n Objekt</numerusform>
            <numerusform>%n Objekte</numerusform>
        </translation>
    </message>
</context>
</TS>
