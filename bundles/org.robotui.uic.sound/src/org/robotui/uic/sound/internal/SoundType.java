package org.robotui.uic.sound.internal;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.osgi.service.component.annotations.ReferenceCardinality;
import org.osgi.service.component.annotations.ReferencePolicy;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Intake;
import org.robotui.api.port.StreamPort;
import org.robotui.api.script.ScriptSource;
import org.robotui.api.script.Scripts;
import org.robotui.condition.TimedCondition;
import org.robotui.data.Data;
import org.robotui.uic.sound.internal.alert.AlertScripts;
import org.robotui.uic.sound.internal.tone.LineSpeaker;
import org.robotui.uic.sound.internal.tone.Player;
import org.robotui.uic.sound.internal.tone.ProgramVoice;
import org.robotui.uic.sound.internal.tone.Sound;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Makes itself heard when something about a robot needs somebody's attention. */
@Component(service = UicType.class)
public final class SoundType implements UicType {
  static final String ALERTS = "alerts";
  static final String VOLUME = "volume";
  static final String MUTED = "muted";
  static final String MUTED_UNTIL = "muted_until";
  static final String NAME = "name";
  static final String WHEN = "when";
  static final String HYSTERESIS = "hysteresis";
  static final String FOR = "for";
  static final String SOUND = "sound";
  static final String REPEAT = "repeat";
  static final String SPEECH = "speech";
  static final String WORDS = "words";
  static final String SCRIPT = "script";

  /** What the conditions look at; nothing else is asked of the robot. */
  static final StreamPort<Data> SIGNALS =
      new StreamPort<>("signals", Data.class, Arity.MANY, "What the conditions of the alerts look at.", Intake.CHOSEN);

  private static final double MOST = 1e12;

  static final Schema ALERT = Schema.of(
      Setting.optional(NAME, new ValueType.Text(), "The name that users see; without it, the condition."),
      Setting.required(WHEN, new ValueType.Text(TextRule.readBy("a condition", text -> TimedCondition.parse(text, 0))),
          "For example battery charge < 0.2, scan stale, link lost, diagnostics >= ERROR, log >= ERROR, or several with "
              + "and, or, not, brackets, + - * /, age(scan) and rate(scan)."),
      Setting.of(HYSTERESIS, new ValueType.Num(0, MOST, ""), 0.0,
          "By how much a number must come back for the alert to end, in its unit."),
      Setting.of(FOR, new ValueType.Num(0, 3600, "s"), 0.0,
          "How long the condition must hold before the alert begins."),
      Setting.of(SOUND,
          new ValueType.WithPlace(
              new ValueType.Text(TextRule.readBy("beep, chime, alarm, or the path of a .wav file", Sound::parse))),
          Placed.nowhere("beep"), "beep, chime, alarm, or the path of a .wav file, relative to the configuration."),
      Setting.of(VOLUME, new ValueType.Num(0, 1, ""), 1.0, "How loud, 0 to 1."),
      Setting.of(SPEECH, new ValueType.Flag(), false,
          "Whether it is spoken as well, by spd-say or espeak-ng where one of them is installed."),
      Setting.optional(WORDS, new ValueType.Text(),
          "What is spoken behind the name of the robot; without it, the name of the alert."),
      Setting.of(REPEAT, new ValueType.Num(0, 3600, "s"), 10.0, "How often it is heard while it lasts; 0 for once."),
      Setting.optional(SCRIPT,
          new ValueType.WithPlace(new ValueType.Text(TextRule.matching("a script, such as go-home.js", ".+\\.js"))),
          "A script that is run when it begins, also where it is muted; a path relative to the configuration."),
      Setting.of(MUTED, new ValueType.Flag(), false, "Whether it is only written to the log."));

  static final Schema SCHEMA = Schema.of(
      Setting.of(ALERTS, new ValueType.ListOf(new ValueType.Section(ALERT)), List.of(), "The alerts."),
      Setting.of(VOLUME, new ValueType.Num(0, 1, ""), 1.0, "How loud all of them are, 0 to 1."),
      Setting.of(MUTED, new ValueType.Flag(), false, "Whether all alerts are muted."),
      Setting.optional(MUTED_UNTIL, new ValueType.Text(TextRule.readBy("a time, such as 2026-11-21T18:00", Mute::time)),
          "Until when all are muted, for example 2026-11-21T18:00 or with Z for UTC."));

  private static final double RATE_HZ = 5;
  private static final Logger LOG = LoggerFactory.getLogger(SoundType.class);

  private static final Descriptor DESCRIPTOR = new Descriptor("sound", "Sound",
      "Sounds an alert while a condition about the robot holds.",
      SCHEMA, List.of(SIGNALS));

  @Reference(cardinality = ReferenceCardinality.MULTIPLE, policy = ReferencePolicy.DYNAMIC)
  private volatile List<Scripts> engines = List.of();

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public List<SettingFault> faults(Settings settings) {
    try {
      AlertReader.read(settings);
    } catch (IllegalArgumentException e) {
      return List.of(Placed.nowhere("").fault(e.getMessage()));
    }
    return settings.list(ALERTS).stream().map(Settings.class::cast)
        .flatMap(alert -> Stream.concat(fault(alert.placed(SOUND)).stream(), script(alert).stream())).toList();
  }

  private static Optional<SettingFault> script(Settings alert) {
    return alert.has(SCRIPT) ? script(alert.placed(SCRIPT)) : Optional.empty();
  }

  private static Optional<SettingFault> script(Placed written) {
    try {
      ScriptSource.read(written.resolve(written.value().toString()));
      return Optional.empty();
    } catch (IOException | InvalidPathException e) {
      return Optional.of(written.fault("'" + SCRIPT + "': " + e.getMessage()));
    }
  }

  private static Optional<SettingFault> fault(Placed sound) {
    return Sound.parse(sound).fault()
        .map(wrong -> sound.fault("'" + SOUND + "' must be a WAV file: " + sound.value() + " " + wrong));
  }

  @Override
  public Surface surface() {
    return Surface.NONE;
  }

  @Override
  public double rateHz() {
    return RATE_HZ;
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    String who = context.ruic().name() + "." + context.instance();
    // A lambda, for a reference to the constructor would link the class at once, also where Java has no sound.
    Player player = new Player(context.background(), () -> new LineSpeaker(),
        new ProgramVoice(System.getenv().getOrDefault("PATH", "/usr/local/bin:/usr/bin:/bin")), TerminalBell::ring,
        reason -> LOG.warn("{}: alerts are written here but not heard: {}", who, reason));
    AlertScripts scripts = new AlertScripts(context.ruic().name(), () -> engines.stream().findFirst(),
        context.background(), context::alert);
    return new SoundUic(context, AlertReader.read(settings), player, scripts);
  }
}
