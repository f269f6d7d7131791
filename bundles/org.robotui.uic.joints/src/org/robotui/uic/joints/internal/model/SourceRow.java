package org.robotui.uic.joints.internal.model;

import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;

/**
 * A source of joints, at one moment.
 *
 * @param source which port it is
 * @param state how it is doing
 * @param joints how many joints it gave
 * @param ageSeconds how old its newest value is, NaN before the first
 */
public record SourceRow(SourceId source, InputState state, int joints, double ageSeconds) {}
