package org.robotui.uic.scene3d.internal.view;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Optional;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.PaletteData;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.config.WriteFailure;
import org.robotui.gl.render.Rendered;
import org.robotui.ui.Health;
import org.robotui.ui.PngFile;
import org.robotui.ui.control.SaveDialog;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.uic.scene3d.internal.SceneParts;

/** Saves pictures of a scene, complete and of any size. */
final class Screenshot {
  private final SceneSurface scene;
  private final SceneParts parts;
  private final Display display;

  Screenshot(SceneSurface scene, SceneParts parts) {
    this.scene = scene;
    this.parts = parts;
    display = scene.canvas().getDisplay();
  }

  /** Asks where to, and saves. Display thread. */
  void save(int width, int height) {
    Optional<Path> file = SaveDialog.ask(scene.canvas(), "Save a picture", "scene.png", "*.png");
    file.ifPresent(f -> save(width, height, f));
  }

  /** Saves; the file is written in the background. */
  void save(int width, int height, Path file) {
    parts.studio().snapshot(width, height)
        .thenAccept(made -> parts.background().execute(() -> tell(write(made, file))));
  }

  /** Writes a picture and says what became of it. */
  static CommandNotice write(Rendered made, Path file) {
    if (!(made instanceof Rendered.Picture picture)) {
      String why = made instanceof Rendered.Unavailable none ? none.reason() : "the scene was closed";
      return new CommandNotice(Health.BAD, "Not saved: " + why);
    }
    try {
      PngFile.write(data(picture), file);
      return new CommandNotice(Health.OK,
          "Saved " + file.getFileName() + " (" + picture.width() + " \u00d7 " + picture.height() + ")");
    } catch (IOException e) {
      return new CommandNotice(Health.BAD, "Not saved: " + WriteFailure.reason(e));
    }
  }

  /** Words of red, green and blue, the highest byte first, after a byte of no meaning. */
  private static ImageData data(Rendered.Picture picture) {
    byte[] bytes = new byte[Integer.BYTES * picture.width() * picture.height()];
    ByteBuffer.wrap(bytes).asIntBuffer().put(picture.rgb(), 0, picture.width() * picture.height());
    return new ImageData(picture.width(), picture.height(), Integer.SIZE, new PaletteData(0xff0000, 0xff00, 0xff),
        Integer.BYTES, bytes);
  }

  private void tell(CommandNotice told) {
    if (!display.isDisposed()) {
      display.asyncExec(() -> {
        if (!scene.canvas().isDisposed()) {
          scene.tools().say(told);
        }
      });
    }
  }
}
