package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.robotui.api.ComponentType;
import org.robotui.api.link.LinkState;
import org.robotui.api.show.Subject;
import org.robotui.core.internal.config.model.CheckedSettings;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.match.Supplier;
import org.robotui.core.internal.port.Offered;
import org.robotui.core.internal.time.RuicClock;
import org.robotui.core.internal.time.RuicFrames;

/**
 * A robot interface that runs to be looked at: with a clock and frames of its own, nobody hears of its failures, and
 * nothing is wired to it. Safe for all threads.
 */
public final class LoneInterface implements AutoCloseable {
  private static final Duration CLOSE_LIMIT = Duration.ofSeconds(2);

  private final ComponentConfig wanted;
  private final Services services;
  private final RficSlot slot;
  private final SerialWorker worker;

  /**
   * Starts it.
   *
   * @param wanted how it is configured
   * @param ruic the name of the RUIC that it is tried for, for messages
   * @param services of the host
   */
  public LoneInterface(ComponentConfig wanted, String ruic, Services services) {
    this.wanted = wanted;
    this.services = services;
    RuicClock clock = new RuicClock(services.clock(), services.wall(), () -> {});
    this.slot = new RficSlot(wanted,
        new Home(ruic, services.with(new Quiet()), clock, new RuicFrames(List.of()), new Untold()));
    this.worker = new SerialWorker("trial-" + ruic + "." + wanted.id());
    worker.execute(slot::start);
  }

  /** How it is configured. */
  public ComponentConfig wanted() {
    return wanted;
  }

  /** Its type, where that is installed. */
  public Optional<? extends ComponentType> type() {
    return slot.find();
  }

  /** What it offers now, sorted by kind and name. */
  public List<Offered> offers() {
    return slot.offers();
  }

  /** What matching has to know of it. */
  public Supplier supplier() {
    return slot.supplier();
  }

  /** How the robot is reached. */
  public LinkState link() {
    return slot.link();
  }

  /** Whether the robot is reached. */
  public boolean isUp() {
    return slot.instance().filter(i -> i.linkNow().isUp()).isPresent();
  }

  /** Why it cannot run, or has failed. */
  public Optional<String> failure() {
    return wrongSettings()
        .or(() -> Optional.of(slot.health()).filter(Health::isFailed).map(h -> slot.id() + " " + h.reason()));
  }

  private Optional<String> wrongSettings() {
    return slot.find()
        .map(type -> services.check().check(type.schema(), wanted.raw()))
        .filter(CheckedSettings.Invalid.class::isInstance)
        .map(i -> Preview.sentences(((CheckedSettings.Invalid) i).problems()));
  }

  RficSlot slot() {
    return slot;
  }

  /** Ends it, and then does something else on its worker. */
  public void closeThen(Runnable next) {
    worker.execute(() -> {
      slot.close(CLOSE_LIMIT);
      next.run();
    });
    worker.close();
  }

  @Override
  public void close() {
    closeThen(() -> {});
  }

  /** What it runs in. */
  private record Home(String ruicName, Services services, RuicClock clock, RuicFrames frames, RuicParts.Wake wake)
      implements ComponentHome {}

  /** What happens to something that only is tried is in its preview. */
  private static final class Quiet implements Events {
    @Override
    public void changed(String ruic) {
      // asked for
    }

    @Override
    public void frameReady(String ruic, String uic) {
      // there are no views
    }

    @Override
    public void showWanted(String from, String wanted) {
      // there are no views
    }

    @Override
    public void viewWanted(String ruic, String uic, String showing, Subject subject) {
      // No view belongs to it.
    }

    @Override
    public void alert(String ruic, String message) {
      // in the preview
    }

    @Override
    public void removed(RuicRuntime ruic) {
      // cannot happen
    }
  }

  /** Nothing is wired, so nothing has to be done. */
  private final class Untold implements RuicParts.Wake {
    @Override
    public void rematch() {
      // previews match when they are asked for
    }

    @Override
    public void linkChanged() {
      // in the preview
    }

    @Override
    public void failed(Object instance, String reason) {
      worker.execute(() -> slot.giveUp(reason));
    }
  }
}
