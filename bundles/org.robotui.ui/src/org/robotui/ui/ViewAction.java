package org.robotui.ui;

import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * Something the user can do in a view.
 *
 * @param id unique within the view
 * @param label what it does, a short imperative
 * @param icon name of an icon of the theme's set, empty for text only
 * @param checked whether it is on, for actions that are switched; asked on the display thread
 * @param run does it, on the display thread
 */
public record ViewAction(String id, String label, String icon, Optional<BooleanSupplier> checked, Runnable run) {}
