package org.robotui.core.internal.life;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import org.robotui.api.config.SetAside;
import org.robotui.core.internal.config.AlertsYaml;
import org.robotui.core.internal.config.Checksum;
import org.robotui.core.internal.config.model.KeptAlerts;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps the alerts of one RUIC in a file. What changes is written a little later, off all threads that must not wait.
 */
final class AlertStore {
  private static final Logger LOG = LoggerFactory.getLogger(AlertStore.class);
  private static final long DELAY_MILLIS = 1000;

  private final Path file;
  private final ScheduledExecutorService timer;
  private final AtomicBoolean scheduled = new AtomicBoolean();
  private final Object writing = new Object();

  AlertStore(Path file, ScheduledExecutorService timer) {
    this.file = file;
    this.timer = timer;
  }

  /** The file of a RUIC: those of one name in two configurations have two. */
  static Path file(Path folder, String configuration, String ruic) {
    return folder.resolve(
        ruic.replaceAll("[^\\p{L}\\p{N}_.-]", "_") + "-" + Checksum.of(configuration + '\n' + ruic) + ".yaml");
  }

  /** What was kept. Where that cannot be understood, the file is set aside, and it begins anew. */
  KeptAlerts read() {
    try {
      return AlertsYaml.read(file);
    } catch (IOException e) {
      LOG.warn("The history of alerts begins anew: {}. {}", e.getMessage(), SetAside.copy(file));
      return KeptAlerts.NONE;
    }
  }

  /** Something has changed. */
  void changed(Supplier<KeptAlerts> now) {
    if (scheduled.compareAndSet(false, true)) {
      timer.schedule(() -> Thread.startVirtualThread(() -> save(now)), DELAY_MILLIS, TimeUnit.MILLISECONDS);
    }
  }

  /** Writes now what was not written yet. Blocks for the file. */
  void save(Supplier<KeptAlerts> now) {
    synchronized (writing) {
      if (scheduled.compareAndSet(true, false)) {
        try {
          AlertsYaml.write(file, now.get());
        } catch (IOException e) {
          LOG.warn("The history of alerts cannot be kept: {} cannot be written: {}", file, e.toString());
        }
      }
    }
  }
}
