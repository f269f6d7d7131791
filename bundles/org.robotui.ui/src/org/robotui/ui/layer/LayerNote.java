package org.robotui.ui.layer;

import org.robotui.ui.Health;

/**
 * What users should know of layers.
 *
 * @param health how grave it is
 * @param text a sentence
 */
public record LayerNote(Health health, String text) {}
