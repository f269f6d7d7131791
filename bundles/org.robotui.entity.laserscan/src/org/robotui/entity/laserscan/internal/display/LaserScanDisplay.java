package org.robotui.entity.laserscan.internal.display;

import java.util.ArrayList;
import java.util.List;
import org.robotui.api.config.Settings;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.Anchor;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Rgba;

/** The newest scan, or those of the last seconds, each where it was measured. */
final class LaserScanDisplay implements Display {
  /** Beams of all scans that stay. */
  private static final long MOST_BEAMS = 2_000_000;

  private final Recent<LaserScan, Echoes> recent =
      new Recent<>(LaserScan.class, Anchor.When.MEASURED, LaserScan::frame, scan -> scan.ranges().size());

  /** Which of the two shapes of a scan. */
  private record Key(int slot, String what) {}

  @Override
  public DisplayResult update(DisplayTick tick) {
    Settings settings = tick.settings();
    recent.update(tick, settings.number("decay"), MOST_BEAMS);
    List<Part> parts = new ArrayList<>();
    List<String> missing = new ArrayList<>();
    int echoes = 0;
    for (Recent.Entry<LaserScan, Echoes> entry : recent.entries()) {
      Echoes prepared = entry.prepared(settings, scan -> Echoes.of(scan, settings));
      entry.anchor().found().ifPresent(place -> add(parts, entry.slot(), prepared, place, tick));
      echoes += prepared.beams().length;
      missing = prepared.missing(settings);
    }
    String words =
        echoes + " echoes" + (recent.entries().size() > 1 ? " of " + recent.entries().size() + " scans" : "");
    DisplayStatus status =
        missing.isEmpty() ? new DisplayStatus.Shown(words) : new DisplayStatus.Partly(missing.getFirst());
    return new DisplayResult(parts, recent.status(tick, status), recent.dropped());
  }

  @Override
  public void close() {
    recent.clear();
  }

  private static void add(List<Part> parts, int slot, Echoes echoes, RigidTransform place, DisplayTick tick) {
    double opacity = tick.settings().number("opacity");
    float pale = Recent.paleness(tick);
    Rgba flat = ColorSetting.read(tick.settings(), "color");
    Material plain = Material.flat(flat.withAlpha(flat.alpha() * opacity)).paled(pale);
    echoes.points().ifPresent(points -> parts.add(new Part(new Key(slot, "points"), points, place,
        points.rgba().isPresent() ? Material.flat(Rgba.WHITE.withAlpha(opacity)).paled(pale) : plain,
        (echo, where) -> echoes.describe(echo))));
    echoes.lines().ifPresent(lines -> parts.add(
        new Part(new Key(slot, "lines"), lines, place, plain,
            Describer.of("laser scan " + echoes.scan().frame().name()))));
  }
}
