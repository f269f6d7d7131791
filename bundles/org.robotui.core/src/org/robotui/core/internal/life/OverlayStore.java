package org.robotui.core.internal.life;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.robotui.api.config.SetAside;
import org.robotui.core.internal.config.model.Overlay;
import org.robotui.core.internal.config.model.OverlayFile;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps what users changed in the RUICs of one configuration. Changes hold at once and are written a little later. A
 * second workbench may keep changes of other RUICs in the same file: what it wrote stays.
 */
public final class OverlayStore {
  private static final Logger LOG = LoggerFactory.getLogger(OverlayStore.class);
  private static final long DELAY_MILLIS = 300;

  private final OverlayFile format;
  private final Path file;
  private final ScheduledExecutorService files;
  private final Consumer<String> teller;
  private final AtomicBoolean scheduled = new AtomicBoolean();
  private final Map<String, Overlay> overlays;
  private final Set<String> changed = new HashSet<>();

  /**
   * Reads what was kept. Where that cannot be understood, the file is set aside, the user is told, and it starts with
   * the rest.
   *
   * @param format reads and writes
   * @param file where
   * @param files does the writing
   * @param teller is given a sentence for the user where something is damaged
   */
  public OverlayStore(OverlayFile format, Path file, ScheduledExecutorService files, Consumer<String> teller) {
    this.format = format;
    this.file = file;
    this.files = files;
    this.teller = teller;
    this.overlays = new TreeMap<>(read());
  }

  private Map<String, Overlay> read() {
    List<String> damage = new ArrayList<>();
    try {
      return format.read(file, damage::add);
    } catch (IOException e) {
      damage.add(e.getMessage());
      return Map.of();
    } finally {
      if (!damage.isEmpty()) {
        setAside(String.join("; ", damage));
      }
    }
  }

  private void setAside(String why) {
    String where = SetAside.copy(file);
    LOG.warn("Of what was changed before something is lost: {}. {}", why, where);
    teller.accept("Of what you had changed in views and layouts something is lost: " + why + ". " + where);
  }

  /** What was changed in one RUIC. */
  public RuicOverlay of(String ruic) {
    return new RuicOverlay(this, ruic);
  }

  OverlayFile format() {
    return format;
  }

  synchronized Overlay get(String ruic) {
    return overlays.getOrDefault(ruic, Overlay.EMPTY);
  }

  void change(String ruic, UnaryOperator<Overlay> change) {
    synchronized (this) {
      changed.add(ruic);
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
        format.write(file, withOthers());
      } catch (IOException e) {
        LOG.warn("What was changed cannot be kept: {} cannot be written: {}", file, e.toString());
      }
    }
  }

  /** What was changed here, and what stands in the file of all others now. */
  private Map<String, Overlay> withOthers() {
    Map<String, Overlay> all = new HashMap<>();
    try {
      all.putAll(format.read(file, damage -> {}));
    } catch (IOException e) {
      LOG.debug("{} cannot be read, and is written anew", file, e);
    }
    synchronized (this) {
      overlays.forEach((ruic, overlay) -> {
        if (changed.contains(ruic)) {
          all.put(ruic, overlay);
        } else {
          all.putIfAbsent(ruic, overlay);
        }
      });
    }
    return all;
  }
}
