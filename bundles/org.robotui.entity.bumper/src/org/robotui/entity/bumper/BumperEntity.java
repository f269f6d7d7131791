package org.robotui.entity.bumper;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.robotui.data.sensor.Bumper;
import org.robotui.data.sensor.Bumpers;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Painter;

/** Bumpers from above: a line where each is; what is pressed is thick and has a halo. */
public final class BumperEntity implements Entity {
  private static final double FREE = 2.2;
  private static final double PRESSED = 4;
  private static final double HALO = 11;
  private static final double FAINT = 0.3;
  /** More than any robot has. */
  private static final int MOST = 1000;

  private volatile List<Strip> strips = List.of();

  /** Without bumpers. */
  public BumperEntity() {
    // The first ones come with prepare.
  }

  /**
   * Takes bumpers in place of those before. Worker thread.
   *
   * @param bumpers of a robot; those whose place is not known are left out
   * @param fixedFromFrame fixed frame from their frame
   */
  public void prepare(Bumpers bumpers, RigidTransform fixedFromFrame) {
    List<Strip> next = new ArrayList<>();
    for (int i = 0; i < Math.min(MOST, bumpers.bumpers().size()); i++) {
      Bumper bumper = bumpers.bumpers().get(i);
      Strip.of(i, bumper, fixedFromFrame).ifPresent(next::add);
    }
    strips = List.copyOf(next);
  }

  @Override
  public void paint(Painter painter) {
    List<Strip> shown = strips;
    painter.stroke(Role.DIM).width(FREE);
    shown.stream().filter(strip -> !strip.pressed()).forEach(strip -> draw(strip, painter));
    painter.stroke(Role.BAD).opacity(FAINT).width(HALO);
    shown.stream().filter(Strip::pressed).forEach(strip -> draw(strip, painter));
    painter.opacity(1).width(PRESSED);
    shown.stream().filter(Strip::pressed).forEach(strip -> draw(strip, painter));
  }

  private static void draw(Strip strip, Painter painter) {
    painter.polyline(strip.line(), strip.line().length / 2);
  }

  @Override
  public Optional<Bounds> bounds() {
    return strips.stream().map(Strip::bounds).reduce(Bounds::union);
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return strips.stream()
        .map(strip -> new Description("bumper " + strip.index() + (strip.pressed() ? ": pressed" : ": free"),
            strip.distance(x, y)))
        .filter(description -> description.distance() <= tolerance)
        .min(Comparator.comparingDouble(Description::distance));
  }
}
