package org.robotui.uic.plot.internal.model;

/** Which trace of which axis, from 0. */
public record TraceRef(int axis, int trace) {}
