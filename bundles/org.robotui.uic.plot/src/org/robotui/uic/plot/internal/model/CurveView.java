package org.robotui.uic.plot.internal.model;

import org.robotui.uic.plot.internal.trace.Curve;

/**
 * What a trace is shown over in place of time.
 *
 * @param curve its points
 * @param signal what lies along the horizontal scale
 * @param label its name
 * @param unit its unit; empty where none is known
 */
public record CurveView(Curve curve, String signal, String label, String unit) {}
