package org.robotui.ui.diagram;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.WriteFailure;
import org.robotui.ui.PngFile;
import org.robotui.ui.Theme;
import org.robotui.ui.control.SaveDialog;

/** Keeps a diagram in a file, as SVG or PNG. Display thread. */
public final class DiagramSaver {
  private static final String SVG = ".svg";
  private static final String PNG = ".png";

  private DiagramSaver() {}

  /**
   * Asks for a file and writes it.
   *
   * @param canvas what is shown
   * @param theme colours
   * @param name that the file would have, without an ending
   * @return what went wrong, as a sentence; none where all is well or the user gave up
   */
  public static Optional<String> ask(DiagramCanvas canvas, Theme theme, String name) {
    return SaveDialog.ask(canvas.control(), "Save the drawing as SVG or PNG", name + SVG, "*" + SVG, "*" + PNG)
        .flatMap(file -> write(canvas, theme, file));
  }

  /**
   * Writes a file.
   *
   * @param canvas what is shown
   * @param theme colours
   * @param file where to; PNG where its name ends so, else SVG
   * @return what went wrong, as a sentence
   */
  public static Optional<String> write(DiagramCanvas canvas, Theme theme, Path file) {
    try {
      if (file.toString().toLowerCase(Locale.ROOT).endsWith(PNG)) {
        PngFile.write(canvas.picture(), file);
      } else {
        AtomicFile.write(file, DiagramSvg.write(canvas.diagram(), theme.palette()));
      }
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of("The drawing was not saved: " + WriteFailure.reason(e));
    }
  }
}
