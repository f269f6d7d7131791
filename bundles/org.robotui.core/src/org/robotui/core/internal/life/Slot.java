package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.ComponentType;
import org.robotui.api.config.Settings;
import org.robotui.core.internal.config.model.CheckedSettings;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.fence.Thrown;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The place of one component in a RUIC, with or without an instance. Changed on the RUIC's worker only, read by all.
 */
abstract class Slot<T extends ComponentType, I extends Instance> {
  private static final Logger LOG = LoggerFactory.getLogger(Slot.class);
  private static final Duration CLOSE_LIMIT = Duration.ofSeconds(2);

  private final ComponentConfig config;
  private final ComponentHome ruic;
  private boolean waitsForType;
  private Optional<T> type = Optional.empty();
  private volatile Health health = Health.ADDED;
  private volatile Optional<I> instance = Optional.empty();

  Slot(ComponentConfig config, ComponentHome ruic) {
    this.config = config;
    this.ruic = ruic;
  }

  abstract Optional<T> find();

  abstract String missing();

  abstract I make(T of, Settings settings);

  /** Makes an instance, in place of any that is there. */
  final void start() {
    close(CLOSE_LIMIT).ifPresent(this::alert);
    type = find();
    waitsForType = type.isEmpty();
    type.ifPresentOrElse(this::tryStart, () -> health = Health.failed(missing()));
  }

  private void tryStart(T found) {
    try {
      startOf(found);
    } catch (RuntimeException | Error e) { // what a type says of itself is foreign code, too
      Thrown.log(LOG, config.id() + " could not be started", e);
      giveUp(
          "threw " + Thrown.text(e) + " when it was started (" + ruic.services().registry().origin(found, found) + ")");
    }
  }

  private void startOf(T found) {
    switch (ruic.services().check().check(found.schema(), config.raw())) {
      case CheckedSettings.Invalid i -> health = Health.failed(Plan.text(i.problems()));
      case CheckedSettings.Valid v -> run(make(found, v.settings()));
    }
  }

  private void run(I made) {
    instance = Optional.of(made);
    health = Health.ADDED;
    try {
      made.start();
      health = Health.RUNNING;
    } catch (Guarded.GuardException e) {
      giveUp(e.getMessage() + " (" + made.origin() + ")");
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      giveUp("starting was interrupted");
    }
  }

  /** The user wants a new instance. */
  void restart() {
    start();
  }

  /** Ends the instance; the component has failed. */
  final void giveUp(String reason) {
    fail(reason, "; ");
    alert(config.id() + " failed: " + health.reason());
  }

  /** Ends the instance; the user is told by a sentence that names the view. */
  final void endLate(String sentence) {
    fail(sentence, " It could not be ended: ");
    alert(health.reason());
  }

  private void fail(String reason, String but) {
    health = Health.failed(reason);
    close(CLOSE_LIMIT).ifPresent(left -> health = Health.failed(reason + but + left));
  }

  private void alert(String message) {
    ruic.services().events().alert(ruic.ruicName(), message);
  }

  /** Ends the instance, where there is one. Returns what could not be ended. */
  final Optional<String> close(Duration limit) {
    List<I> ending = instance.stream().toList();
    List<String> left = new ArrayList<>();
    end(limit).ifPresent(left::add);
    left.addAll(ruic.strays(ending));
    return left.isEmpty() ? Optional.empty() : Optional.of(String.join("; ", left));
  }

  /**
   * The same for one of several that end together: what they leave that is known to nobody is looked for once they all
   * have.
   */
  final Optional<String> end(Duration limit) {
    Optional<I> ending = instance;
    instance = Optional.empty();
    return ending.flatMap(i -> i.close(limit));
  }

  /** Takes up that types have come or gone. True where that concerns this component. */
  final boolean typesChanged() {
    Optional<T> found = find();
    boolean lost = type.isPresent() && !type.equals(found);
    boolean back = (waitsForType || lost) && found.isPresent();
    if (lost) {
      type = Optional.empty();
      waitsForType = true;
      giveUp(missing());
    }
    if (back) {
      start();
    }
    return lost || back;
  }

  final String id() {
    return config.id();
  }

  final ComponentConfig config() {
    return config;
  }

  final ComponentHome ruic() {
    return ruic;
  }

  final Health health() {
    return health;
  }

  final Optional<I> instance() {
    return instance;
  }
}
