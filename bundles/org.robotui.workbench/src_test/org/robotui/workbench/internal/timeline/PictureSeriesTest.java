package org.robotui.workbench.internal.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageLoader;
import org.eclipse.swt.graphics.PaletteData;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.replay.TimeRange;

/** Which pictures are taken of a part of the recordings. */
class PictureSeriesTest {
  private static final long SECOND = 1_000_000_000L;

  @TempDir
  private Path folder;
  private final PretendTimeline timeline = new PretendTimeline().filled();
  private final Drawing view = new Drawing();

  /** Draws where the timeline is, some ticks later. */
  private final class Drawing implements PictureSource {
    private long ticks;
    private long since;
    private long position = Long.MIN_VALUE;

    @Override
    public long ticks() {
      if (timeline.state().position() != position) {
        position = timeline.state().position();
        since = ticks;
      }
      return ticks++;
    }

    @Override
    public ImageData picture() {
      long drawn = Math.min(5, ticks - since); // done after five
      ImageData data = new ImageData(2, 1, 24, new PaletteData(0xff0000, 0xff00, 0xff));
      data.setPixel(0, 0, 0x010101 * (int) ((position - PretendTimeline.BEGIN) / (SECOND / 10))); // a grey
      data.setPixel(1, 0, (int) drawn);
      return data;
    }
  }

  /** Keeps what it is given. */
  private static final class Kept implements PictureTarget {
    private final List<String> all = new ArrayList<>();

    @Override
    public void add(ImageData picture) {
      all.add((picture.getPixel(0, 0) & 0xff) + "/" + picture.getPixel(1, 0));
    }

    @Override
    public void finish() {
      all.add("finished");
    }

    @Override
    public void close() {
      all.add("closed");
    }
  }

  private static PictureSteps steps(double from, double to, double rate) {
    return new PictureSteps(new TimeRange(PretendTimeline.BEGIN + Math.round(from * SECOND),
        PretendTimeline.BEGIN + Math.round(to * SECOND)), rate);
  }

  private int take(PictureSteps steps, PictureTarget target, BooleanSupplier cancelled) throws Exception {
    return new PictureSeries(timeline, view, cancelled).take(steps, target, taken -> {});
  }

  @Test
  void eachIsOfItsTimeAndDrawnToTheEnd() throws Exception {
    long before = timeline.state().position();
    Kept kept = new Kept();
    assertEquals(5, take(steps(1, 3, 2), kept, () -> false));
    assertEquals(List.of("10/5", "15/5", "20/5", "25/5", "30/5", "finished", "closed"), kept.all);
    assertEquals(before, timeline.state().position(), "it goes back");
    assertTrue(timeline.asked.contains("advance 1500000000"), "nothing jumps: " + timeline.asked);
  }

  @Test
  void whatIsCancelledKeepsWhatThereIs() throws Exception {
    AtomicBoolean cancelled = new AtomicBoolean();
    Kept kept = new Kept();
    int taken = new PictureSeries(timeline, view, cancelled::get).take(steps(1, 3, 2), kept,
        count -> cancelled.set(count == 2));
    assertEquals(2, taken);
    assertEquals(List.of("10/5", "15/5", "finished", "closed"), kept.all);
  }

  @Test
  void filesAreNumberedAndNeverWrittenOver() throws Exception {
    Path there = Files.writeString(folder.resolve("map-00003.png"), "mine");
    IOException refused = assertThrows(IOException.class,
        () -> take(steps(1, 3, 2), new NumberedPictures(folder.resolve("map.png")), () -> false));
    assertEquals(there + " is there already: choose another name", refused.getMessage());
    assertEquals("mine", Files.readString(there));
    ImageData second = new ImageLoader().load(folder.resolve("map-00002.png").toString())[0];
    assertEquals(2, second.width);
  }

  @Test
  void aFolderThatIsGoneIsSaid() {
    IOException refused = assertThrows(IOException.class,
        () -> take(steps(0, 1, 1), new NumberedPictures(folder.resolve("gone/map.png")), () -> false));
    assertTrue(refused.getMessage().startsWith(folder.resolve("gone/map-00001.png") + " could not be written: "),
        refused.getMessage());
  }

  @Test
  void recordingsThatAreClosedEndIt() {
    timeline.empty();
    IOException refused = assertThrows(IOException.class, () -> take(steps(0, 1, 1), new Kept(), () -> false));
    assertEquals("no recording is open any more", refused.getMessage());
  }
}
