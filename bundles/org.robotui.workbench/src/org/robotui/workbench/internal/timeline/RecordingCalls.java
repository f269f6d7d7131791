package org.robotui.workbench.internal.timeline;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.WriteFailure;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Calls that read recordings: each on a thread of its own; what became of it is told on the display thread. */
public final class RecordingCalls {
  private static final Logger LOG = LoggerFactory.getLogger(RecordingCalls.class);

  private final Executor display;
  private final Executor workers;

  /**
   * Reads recordings.
   *
   * @param <V> what is read
   */
  interface Call<V> {
    V call() throws IOException, InterruptedException;
  }

  /**
   * What became of a call.
   *
   * @param <V> what was read
   */
  sealed interface Answer<V> {
    record Given<V>(V value) implements Answer<V> {}

    /** With a sentence for users. */
    record Failed<V>(String why) implements Answer<V> {}
  }

  /**
   * With nothing to do yet.
   *
   * @param display runs tasks on the display thread, later and one after another
   * @param workers runs each task on a thread of its own
   */
  public RecordingCalls(Executor display, Executor workers) {
    this.display = display;
    this.workers = workers;
  }

  <V> void start(Call<V> call, Consumer<Answer<V>> told) {
    workers.execute(() -> {
      Answer<V> answer = answer(call);
      display.execute(() -> told.accept(answer));
    });
  }

  /** Writes a text to a file, in place of what is there; fails with a sentence. */
  static Path write(Path file, String text) throws IOException {
    try {
      AtomicFile.write(file, text);
    } catch (IOException e) {
      throw new IOException(file + " could not be written: " + WriteFailure.reason(e), e);
    }
    return file;
  }

  private static <V> Answer<V> answer(Call<V> call) {
    try {
      return new Answer.Given<>(call.call());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return new Answer.Failed<>("it was interrupted");
    } catch (IOException | IllegalArgumentException e) {
      return new Answer.Failed<>(String.valueOf(e.getMessage()));
    } catch (RuntimeException e) {
      LOG.error("a call that reads recordings failed", e);
      return new Answer.Failed<>("it failed: " + e);
    }
  }
}
