package org.robotui.ui.scene;

import org.robotui.ui.Health;

/**
 * What became of something that the user did.
 *
 * @param health whether it worked
 * @param text a short sentence
 */
public record CommandNotice(Health health, String text) {}
