package org.robotui.uic.gps.internal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageLoader;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.sensor.GpsFix;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

/**
 * Paints the view in all its states into files, for people to look at: {@code GpsGallery FOLDER [FIXES]}, where a line
 * of the file has time, latitude, longitude in degrees and status, variance of a NavSatFix.
 */
final class GpsGallery {
  private final Display display;
  private final Theme theme;
  private final Path folder;

  private GpsGallery(Display display, Theme theme, Path folder) {
    this.display = display;
    this.theme = theme;
    this.folder = folder;
  }

  public static void main(String[] arguments) throws IOException {
    Display display = new Display();
    Files.createDirectories(Path.of(arguments[0]));
    for (String id : Themes.ids()) {
      Theme theme = Themes.of(display, id);
      GpsGallery gallery = new GpsGallery(display, theme, Path.of(arguments[0]));
      gallery.states();
      gallery.several();
      gallery.hours();
      if (arguments.length > 1) {
        gallery.real(Files.readAllLines(Path.of(arguments[1])));
      }
      theme.dispose();
    }
    display.dispose();
  }

  private void states() throws IOException {
    GpsStage stage = new GpsStage(display, theme, 520, 300);
    stage.open();
    stage.context.input(GpsType.FIX)
        .state(new InputState.Unconnected("gps needs GpsFix on 'fix'; no robot interface offers one"));
    save(stage, "empty");
    stage.context.input(GpsType.FIX).state(new InputState.Waiting("/fix has a publisher, nothing came yet"));
    save(stage, "waiting");
    stage.put("base", GpsStage.fix("Keira", GpsFix.Quality.NO_FIX, Double.NaN, Double.NaN, Double.NaN));
    save(stage, "never");
    for (int i = 0; i < 40; i++) {
      stage.put("base", GpsStage.fix("Keira", i < 15 ? GpsFix.Quality.FIX
          : i < 28 ? GpsFix.Quality.SATELLITE_AUGMENTED
              : GpsFix.Quality.GROUND_AUGMENTED,
          51.4934 + 2e-6 * i, 7.4197 + 2e-5 * Math.sin(i * 0.15), i < 15 ? 2.4 : 0.4));
    }
    save(stage, "live");
    stage.put("base", GpsStage.fix("Keira", GpsFix.Quality.NO_FIX, Double.NaN, Double.NaN, Double.NaN));
    save(stage, "lost");
    stage.context.input(GpsType.FIX).state(new SourceId("base", "fix"), new InputState.Stale(3.4, "no data"));
    save(stage, "stale");
    stage.close();
  }

  private void several() throws IOException {
    GpsStage stage = new GpsStage(display, theme, 700, 440);
    stage.open();
    for (int i = 0; i < 120; i++) {
      stage.put("keira", GpsStage.fix("Keira", GpsFix.Quality.GROUND_AUGMENTED, -17.8 + 3e-6 * i,
          179.9999 + 1e-5 * Math.sin(i * 0.05), 0.02));
      stage.put("rover", GpsStage.fix("Rover", GpsFix.Quality.FIX, -17.8 + 3e-4 * Math.cos(i * 0.02),
          -179.9995 + 3e-4 * Math.sin(i * 0.02), 4.2));
      stage.put("far", GpsStage.fix("Zeppelin", GpsFix.Quality.SATELLITE_AUGMENTED, 51.4, 7.4, 1));
    }
    stage.put("dog", GpsStage.fix("Dog", GpsFix.Quality.FIX, -17.8002, 179.9997, 12));
    stage.put("dog", GpsStage.fix("Dog", GpsFix.Quality.NO_FIX, Double.NaN, Double.NaN, Double.NaN));
    stage.tick();
    stage.key('m');
    stage.mouse(SWT.MouseDown, 1, 200, 300);
    stage.mouse(SWT.MouseUp, 1, 200, 300);
    stage.mouse(SWT.MouseMove, 0, 420, 180);
    save(stage, "several");
    stage.close();
  }

  private void hours() throws IOException {
    GpsStage stage = new GpsStage(display, theme, 700, 440);
    stage.open();
    long start = System.nanoTime();
    int count = 4 * 36_000;
    for (int i = 0; i < count; i++) {
      double t = i * 1e-3;
      stage.put("base", GpsStage.fix("Keira", GpsFix.Quality.FIX, 51.49 + 2e-3 * Math.sin(t * 0.31),
          7.41 + 2e-3 * Math.cos(t * 0.17), 1));
    }
    double tick = (System.nanoTime() - start) * 1e-3 / count;
    save(stage, "hours");
    stage.tick();
    Files.writeString(folder.resolve("timing-" + theme.id() + ".txt"), String.format(Locale.ROOT,
        "4 h at 10 Hz: %.1f us a tick, paint %.1f ms%n", tick, stage.canvas().paintNanos() * 1e-6));
    stage.close();
  }

  private void real(List<String> lines) throws IOException {
    GpsStage stage = new GpsStage(display, theme, 700, 440);
    stage.open();
    for (String line : lines) {
      String[] words = line.split(" ");
      GpsFix.Quality quality = GpsFix.Quality.values()[Integer.parseInt(words[3]) + 1];
      stage.put("husky", GpsStage.fix("Husky", quality, Double.parseDouble(words[1]), Double.parseDouble(words[2]),
          Math.sqrt(Double.parseDouble(words[4]))));
    }
    stage.tick();
    save(stage, "husky");
    stage.key('f');
    for (int i = 0; i < 5; i++) {
      stage.key('+');
    }
    stage.key('d');
    save(stage, "husky-near");
    stage.close();
  }

  private void save(GpsStage stage, String name) throws IOException {
    stage.tick();
    ImageLoader loader = new ImageLoader();
    loader.data = new ImageData[]{stage.picture()};
    loader.save(folder.resolve(name + "-" + theme.id() + ".png").toString(), SWT.IMAGE_PNG);
  }
}
