package org.robotui.entity.image.internal;

import java.util.Optional;
import org.eclipse.swt.graphics.ImageData;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.entity.image.ColorMap;
import org.robotui.entity.image.Legend;
import org.robotui.entity.image.Picture;
import org.robotui.entity.image.Rendering;
import org.robotui.entity.image.Span;

/** Pictures of numbers: depth, temperatures, 16 bits of grey, and the length of vectors of two. */
final class Measured {
  private static final int SHADES = 1024;
  private static final int SAMPLED_ROWS = 96;
  private static final int SAMPLED_COLUMNS = 128;

  private final RawImage raw;
  private final Rendering rendering;
  private final ColorMap map;
  private final Quantity quantity;
  private final Samples samples;
  private final float[] row;

  private Measured(RawImage raw, Rendering rendering) {
    this.raw = raw;
    this.rendering = rendering;
    this.map = rendering.map().orElse(raw.encoding() == PixelEncoding.MONO16 ? ColorMap.GREY : ColorMap.TURBO);
    this.quantity = Quantity.of(raw.encoding(), rendering.depth());
    this.samples = new Samples(raw);
    this.row = new float[samples.perRow()];
  }

  static Picture decode(RawImage raw, Rendering rendering, Levels levels) {
    return new Measured(raw, rendering).picture(levels);
  }

  private Picture picture(Levels levels) {
    Span sent = rendering.range()
        .map(r -> new Span(r.low() / quantity.scale(), r.high() / quantity.scale()))
        .orElseGet(() -> follow(levels));
    Span span = rendering.range().orElse(new Span(sent.low() * quantity.scale(), sent.high() * quantity.scale()));
    Optional<RawImage> numbers = raw.encoding().channels() == 1 ? Optional.of(raw) : Optional.empty();
    return new Picture(pixels(sent), raw.encoding().rosName(), new RawValues(raw, quantity),
        Optional.of(new Legend(map, rendering.reversed(), span, rendering.range().isEmpty(), gaps(), quantity.unit())),
        numbers);
  }

  private boolean gaps() {
    return quantity.depth() || switch (raw.encoding().sample()) {
      case F32, F64 -> true;
      default -> false;
    };
  }

  private Span follow(Levels levels) {
    float[] some = new float[SAMPLED_ROWS * SAMPLED_COLUMNS];
    int down = Math.max(1, raw.height() / SAMPLED_ROWS + 1);
    int across = Math.max(1, raw.width() / SAMPLED_COLUMNS + 1);
    int count = 0;
    for (int y = down / 2; y < raw.height(); y += down) {
      numbers(y);
      for (int x = (y / down) % across; x < raw.width(); x += across) {
        if (quantity.measured(row[x])) {
          some[count++] = row[x];
        }
      }
    }
    return levels.follow(some, count);
  }

  private ImageData pixels(Span sent) {
    int[] shades = map.table(SHADES, rendering.reversed());
    int nothing = map.nothing();
    float least = quantity.depth() ? Float.MIN_VALUE : -Float.MAX_VALUE;
    float low = (float) sent.low();
    float factor = (float) ((SHADES - 1) / (sent.high() - sent.low()));
    Raster raster = new Raster(raw.width(), raw.height());
    for (int y = 0; y < raw.height(); y++) {
      numbers(y);
      for (int x = 0; x < raw.width(); x++) {
        float number = row[x];
        // The comparisons leave out what is not a number, too.
        boolean measured = number >= least && number <= Float.MAX_VALUE;
        int shade = (int) ((number - low) * factor + 0.5f);
        raster.put(measured ? shades[shade < 0 ? 0 : Math.min(shade, SHADES - 1)] : nothing);
      }
    }
    return raster.data();
  }

  private void numbers(int y) {
    samples.real(y, row);
    if (raw.encoding().channels() == 2) {
      for (int x = 0; x < raw.width(); x++) {
        row[x] = (float) Math.sqrt(row[2 * x] * row[2 * x] + row[2 * x + 1] * row[2 * x + 1]);
      }
    }
  }
}
