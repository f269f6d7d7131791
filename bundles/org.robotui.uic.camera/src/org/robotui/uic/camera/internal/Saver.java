package org.robotui.uic.camera.internal;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.WriteFailure;
import org.robotui.entity.image.Picture;
import org.robotui.entity.image.PicturePng;

/** Saves pictures as PNG: ordered on the display thread, written in the background. */
final class Saver {
  private static final long SHOWN_NANOS = 4_000_000_000L;

  private final Executor background;
  private volatile Optional<Told> told = Optional.empty();
  private Optional<Told> seen = Optional.empty();
  private long since;

  Saver(Executor background) {
    this.background = background;
  }

  /** What of a picture is kept. */
  enum Part {
    /** As it is seen. */
    COLORS,
    /** The numbers behind the colours, 16 bits. */
    NUMBERS
  }

  private record Told(String words) {}

  /** Has a picture saved. */
  void save(Picture picture, Part part, String file) {
    background.execute(() -> told = Optional.of(new Told(write(picture, part, file))));
  }

  /** Says for a few seconds what became of it. */
  Optional<String> tick(long now) {
    Optional<Told> latest = told;
    if (!latest.equals(seen) || latest.isPresent() && seen.isPresent() && latest.get() != seen.get()) {
      seen = latest;
      since = now;
    }
    return seen.filter(m -> now - since < SHOWN_NANOS).map(Told::words);
  }

  private static String write(Picture picture, Part part, String file) {
    try {
      Optional<byte[]> bytes =
          part == Part.COLORS ? Optional.of(PicturePng.seen(picture)) : PicturePng.numbers(picture);
      if (bytes.isEmpty()) {
        return "cannot save " + file + ": the picture holds no numbers of 16 bits";
      }
      AtomicFile.write(Path.of(file), out -> out.write(bytes.get()));
      return "saved " + file;
    } catch (IOException e) {
      return "cannot save " + file + ": " + WriteFailure.reason(e);
    } catch (RuntimeException e) {
      return "cannot save " + file + ": " + (e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage());
    }
  }
}
