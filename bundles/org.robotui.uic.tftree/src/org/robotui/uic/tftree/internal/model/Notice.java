package org.robotui.uic.tftree.internal.model;

import org.robotui.ui.Health;

/**
 * Something that is wrong, or worth knowing.
 *
 * @param health its dot
 * @param words a sentence
 */
public record Notice(Health health, String words) {}
