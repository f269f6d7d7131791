package org.robotui.ui.layer;

/**
 * What a tick made of a layer.
 *
 * @param changed whether something else is to be painted than before
 * @param status how it is
 */
public record LayerResult(boolean changed, LayerStatus status) {}
