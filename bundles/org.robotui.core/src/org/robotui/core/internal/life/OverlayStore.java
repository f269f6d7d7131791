package org.robotui.core.internal.life;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.UnaryOperator;
import org.robotui.core.internal.config.model.Overlay;
import org.robotui.core.internal.config.model.OverlayFile;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Keeps what users changed in the RUICs of one configuration. Changes hold at once and are written a little later. */
public final class OverlayStore {
  private static final Logger LOG = LoggerFactory.getLogger(OverlayStore.class);
  private static final long DELAY_MILLIS = 300;

  private final OverlayFile format;
  private final Path file;
  private final ScheduledExecutorService files;
  private final AtomicBoolean scheduled = new AtomicBoolean();
  private final Map<String, Overlay> overlays;

  /**
   * Reads what was kept; where that cannot be read, it starts empty and says so in the log.
   *
   * @param format reads and writes
   * @param file where
   * @param files does the writing
   */
  public OverlayStore(OverlayFile format, Path file, ScheduledExecutorService files) {
    this.format = format;
    this.file = file;
    this.files = files;
    this.overlays = new TreeMap<>(read(format, file));
  }

  private static Map<String, Overlay> read(OverlayFile format, Path file) {
    try {
      return format.read(file);
    } catch (IOException e) {
      LOG.warn("What was changed before is lost: {} cannot be read: {}", file, e.toString());
      return Map.of();
    }
  }

  /** What was changed in one RUIC. */
  public RuicOverlay of(String ruic) {
    return new RuicOverlay(this, ruic);
  }

  synchronized Overlay get(String ruic) {
    return overlays.getOrDefault(ruic, Overlay.EMPTY);
  }

  void change(String ruic, UnaryOperator<Overlay> change) {
    synchronized (this) {
      overlays.put(ruic, change.apply(get(ruic)));
    }
    if (scheduled.compareAndSet(false, true)) {
      files.schedule(this::save, DELAY_MILLIS, TimeUnit.MILLISECONDS);
    }
  }

  /** Writes now what was not written yet. Blocks for the file. */
  public void save() {
    if (scheduled.compareAndSet(true, false)) {
      try {
        format.write(file, copy());
      } catch (IOException e) {
        LOG.warn("What was changed cannot be kept: {} cannot be written: {}", file, e.toString());
      }
    }
  }

  private synchronized Map<String, Overlay> copy() {
    return new HashMap<>(overlays);
  }
}
