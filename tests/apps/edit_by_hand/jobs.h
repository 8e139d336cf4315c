// Jobs of set dressing by hand. Goals: no job but leaning needs more than the mouse on the objects,
// and none needs a tool.
#pragma once

#include "apps/edit_by_hand/at_work.h"

namespace trivet::edit::test {

/// Eleven objects from beside a table onto it: eleven drags.
void lay_breakfast(AtWork& work);
/// The saucer takes its cup along: one drag.
void move_the_saucer(AtWork& work);
/// Apples into a bowl, on each other: one pour.
void pour_fruit(AtWork& work);
/// A mug on its side: a click and a key.
void lay_mug(AtWork& work);
/// A crate a thousand times too large: selected as it is imported, its unit is chosen.
void mend_unit(AtWork& work);
/// A desk with nine things on it: one drag.
void move_desk(AtWork& work);
/// An office of eleven objects, then the desk with all that it carries: twelve drags.
void furnish_office(AtWork& work);
/// 24 books that stand, and five that lean: a drag and an array, then a drag and a key for each.
void fill_bookshelf(AtWork& work);

/// An action that is found by a word, and done by Return.
void find_action(AtWork& work);
/// Keys are for the view under the mouse, but while a field is edited; Return gives them back.
void edit_and_return(AtWork& work);

}  // namespace trivet::edit::test
