package org.robotui.sim.internal.world;

/** Where a ray runs through a solid. Mutable on purpose: one is reused for thousands of rays a second. */
public final class RaySpan {
  double enter;
  double exit;
  int edge;

  /** Ray parameter where the ray comes in; not positive if it starts inside. */
  public double enter() {
    return enter;
  }

  public double exit() {
    return exit;
  }

  /** Index of the edge through which the ray comes in, -1 if it starts inside. */
  public int edge() {
    return edge;
  }
}
