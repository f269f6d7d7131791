package org.robotui.workbench.internal.timeline;

import java.io.IOException;
import java.util.Arrays;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import org.eclipse.swt.graphics.ImageData;
import org.robotui.api.replay.Timeline;

/**
 * Goes through a part of the recordings and takes a picture of a view at each step, once the view has drawn what is of
 * that time: all that lies before it was delivered, the view has ticked since, and two pictures in a row are alike. For
 * one thread, which waits.
 */
final class PictureSeries {
  private static final long POLL_MILLIS = 2;
  private static final long PATIENCE_NANOS = 60_000_000_000L;
  /** One tick may have begun before the last value came. */
  private static final int TICKS = 2;
  /** What moves by itself, such as a cursor that blinks, never stands still. */
  private static final int MOST_LOOKS = 20;

  private final Timeline timeline;
  private final PictureSource view;
  private final BooleanSupplier cancelled;

  PictureSeries(Timeline timeline, PictureSource view, BooleanSupplier cancelled) {
    this.timeline = timeline;
    this.view = view;
    this.cancelled = cancelled;
  }

  /** Takes all pictures, or those until it is cancelled; answers how many. The timeline goes back where it was. */
  int take(PictureSteps steps, PictureTarget target, IntConsumer progress) throws IOException, InterruptedException {
    long before = timeline.state().position();
    timeline.pause();
    int taken = 0;
    try {
      for (int i = 0; i < steps.count() && !cancelled.getAsBoolean(); i++) {
        go(steps.time(i), i == 0);
        target.add(still());
        taken = i + 1;
        progress.accept(taken);
      }
      target.finish();
      return taken;
    } finally {
      target.close();
      timeline.seek(before);
    }
  }

  private void go(long time, boolean first) throws IOException, InterruptedException {
    if (timeline.state().span().isEmpty()) {
      throw new IOException("no recording is open any more");
    }
    if (first) {
      timeline.seek(time);
    } else {
      timeline.advance(time);
    }
    await(timeline::isThere, "the recording did not come to that time within a minute");
    tick(TICKS);
  }

  private void tick(int times) throws IOException, InterruptedException {
    long from = view.ticks();
    await(() -> view.ticks() >= from + times, "the view took up nothing for a minute: is it closed, or not in front?");
  }

  private ImageData still() throws IOException, InterruptedException {
    ImageData last = view.picture();
    for (int i = 0; i < MOST_LOOKS; i++) {
      tick(1);
      ImageData next = view.picture();
      if (Arrays.equals(last.data, next.data)) {
        return next;
      }
      last = next;
    }
    return last;
  }

  private void await(BooleanSupplier condition, String failure) throws IOException, InterruptedException {
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (!condition.getAsBoolean() && !cancelled.getAsBoolean()) {
      if (System.nanoTime() > end) {
        throw new IOException(failure);
      }
      Thread.sleep(POLL_MILLIS);
    }
  }
}
