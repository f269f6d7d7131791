package org.robotui.entity.bumper.internal.display;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.data.sensor.Bumper;
import org.robotui.data.sensor.Bumpers;
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
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Properties.Entry;
import org.robotui.gl.shape.Rgba;

/** The newest state of the bumpers, on the robot where it is now. */
final class BumperDisplay implements Display {
  private final Recent<Bumpers, Bands> recent =
      new Recent<>(Bumpers.class, Anchor.When.NOW, Bumpers::frame, bumpers -> 1);

  @Override
  public DisplayResult update(DisplayTick tick) {
    recent.update(tick);
    Optional<Recent.Entry<Bumpers, Bands>> newest = recent.newest();
    if (newest.isEmpty()) {
      return DisplayResult.nothing(recent.status(tick, new DisplayStatus.Shown("")));
    }
    Bands.Look look = look(tick);
    Bands bands = newest.get().prepared(look, bumpers -> Bands.of(bumpers, look));
    List<Part> parts = bands.count() == 0 ? List.of()
        : newest.get().anchor().found().map(at -> part(newest.get().value(), bands, at, tick)).stream().toList();
    return new DisplayResult(parts, recent.status(tick, seen(newest.get().value(), bands)), recent.dropped());
  }

  private static Bands.Look look(DisplayTick tick) {
    return new Bands.Look(ColorSetting.read(tick.settings(), BumperType.COLOR),
        ColorSetting.read(tick.settings(), BumperType.PRESSED_COLOR),
        tick.settings().number(BumperType.HEIGHT));
  }

  private static DisplayStatus seen(Bumpers bumpers, Bands bands) {
    int all = bumpers.bumpers().size();
    String words = bumpers.pressed() + " of " + all + " pressed";
    if (bands.bumpers() == all) {
      return new DisplayStatus.Shown(words);
    }
    return new DisplayStatus.Partly(words + "; " + (all > Bands.MOST ? "the first " + Bands.MOST + " are drawn"
        : "the robot does not tell where " + (all - bands.bumpers()) + " of them are"));
  }

  private static Part part(Bumpers bumpers, Bands bands, RigidTransform at, DisplayTick tick) {
    return new Part("bumpers", bands.shape(), at, Material.lit(Rgba.WHITE.withAlpha(Recent.opacity(tick))),
        describer(bumpers, bands));
  }

  private static Describer describer(Bumpers bumpers, Bands bands) {
    return (element, place) -> {
      int index = bands.bumper(element);
      Bumper bumper = bumpers.bumpers().get(index);
      return Properties.of("bumper " + index, new Entry("state", bumper.pressed() ? "pressed" : "free"),
          new Entry("frame", bumpers.frame().name()), new Entry("length", metres(bumper.length())),
          new Entry("radius", bumper.radius() > 0 ? metres(bumper.radius()) : "straight"));
    };
  }

  private static String metres(double value) {
    return String.format(Locale.ROOT, "%.3f m", value);
  }

  @Override
  public void close() {
    recent.clear();
  }
}
