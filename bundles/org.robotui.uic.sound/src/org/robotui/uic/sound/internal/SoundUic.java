package org.robotui.uic.sound.internal;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.config.Settings;
import org.robotui.uic.sound.internal.alert.Alert;
import org.robotui.uic.sound.internal.alert.AlertConfig;
import org.robotui.uic.sound.internal.alert.AlertScripts;
import org.robotui.uic.sound.internal.tone.Player;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Watches the conditions of a robot's alerts, tells the user, which core also writes to the log, has them heard, and
 * runs their scripts.
 */
final class SoundUic implements Uic {
  private static final Logger LOG = LoggerFactory.getLogger(SoundUic.class);

  private final UicContext context;
  private final List<Alert> alerts;
  private final Player player;
  private final AlertScripts scripts;
  private final RobotSignals signals;
  private final String robot;
  private String mistake = "";
  private Optional<Instant> muted = Optional.empty();

  SoundUic(UicContext context, List<AlertConfig> alerts, Player player, AlertScripts scripts) {
    this.context = context;
    this.alerts = alerts.stream().map(Alert::new).toList();
    this.player = player;
    this.scripts = scripts;
    this.robot = context.ruic().name();
    this.signals = new RobotSignals(context.input(SoundType.SIGNALS), context.ruic(),
        candidate -> alerts.stream().anyMatch(alert -> alert.condition().needs().test(candidate)));
  }

  @Override
  public boolean tick(long nowNanos) {
    signals.take();
    mute(context.settings().current());
    for (Alert alert : alerts) {
      act(alert, alert.step(signals, nowNanos));
    }
    return false;
  }

  List<Alert> alerts() {
    return alerts;
  }

  private void act(Alert alert, Alert.Step step) {
    switch (step) {
      case RAISED -> {
        context.alert(alert.config().name() + ": " + alert.detail());
        list(alert);
        sound(alert);
        scripts.begin(alert.config(), alert.seen());
      }
      case REPEATED -> {
        list(alert);
        sound(alert);
      }
      case LASTS -> list(alert);
      case ENDED -> {
        LOG.info("{}: {} is over", robot, alert.config().name());
        context.alerts().end(alert.config().name());
      }
      case WRONG -> context.alert("the alert '" + alert.config().name() + "' cannot work: " + alert.detail());
      case NONE -> {}
    }
  }

  /** What users see of it. An entry of a log is over as soon as it is told. */
  private void list(Alert alert) {
    AlertConfig config = alert.config();
    alert.seen().ifPresent(seen -> context.alerts().raise(config.name(), config.when(), seen.source(), seen.value()));
    if (config.condition().momentary()) {
      context.alerts().end(config.name());
    }
  }

  private void sound(Alert alert) {
    Settings settings = context.settings().current();
    if (!alert.config().muted() && context.alerts().isHeard(alert.config().name())) {
      player.play(alert.config().name(), alert.config().sound(),
          alert.config().volume() * settings.number(SoundType.VOLUME), words(alert.config()));
    }
  }

  private String words(AlertConfig config) {
    return config.words().isEmpty() ? "" : robot + ": " + config.words();
  }

  /** What the settings say of muting counts when it changes, so that users can unmute by hand. */
  private void mute(Settings settings) {
    Optional<Instant> next = until(settings);
    if (!next.equals(muted)) {
      muted = next;
      context.ruic().alerts().muteAll(next);
    }
  }

  /** A time that cannot be read mutes nothing: better heard than missed. */
  private Optional<Instant> until(Settings settings) {
    try {
      return Mute.until(settings);
    } catch (IllegalArgumentException e) {
      if (!mistake.equals(e.getMessage())) {
        mistake = e.getMessage();
        LOG.warn("{}: {}", robot, mistake);
      }
      return Optional.empty();
    }
  }

  @Override
  public void close() {
    // What sounds is interrupted by core, whose threads it uses.
    scripts.close();
  }
}
