package org.robotui.recorder.internal.function;

import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.record.Recorder;
import org.robotui.api.record.RecorderState;
import org.robotui.api.record.RecordingChoice;
import org.robotui.api.record.RecordingOutcome;
import org.robotui.api.record.RecordingPacking;
import org.robotui.api.record.RecordingPlan;
import org.robotui.api.record.RecordingStatus;
import org.robotui.api.script.ScriptCall;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;
import org.robotui.api.script.ScriptFunctions;

/** Recording, for scripts. */
@Component(service = ScriptFunctions.class)
public final class RecordingFunctions implements ScriptFunctions {
  private static final String ROBOTS = "robots";
  private static final String PORTS = "ports";
  private static final Set<String> CHOICE = Set.of(ROBOTS, PORTS);
  private static final Set<String> ALL = Set.of(ROBOTS, PORTS, "compression", "splitBytes", "splitSeconds");
  private static final double USUAL_SECONDS = 30;

  private final Recorder recorder;

  /** Called by declarative services. */
  @Activate
  public RecordingFunctions(@Reference Recorder recorder) {
    this.recorder = recorder;
  }

  @Override
  public List<ScriptFunction> functions() {
    return List.of(
        ScriptFunction.of("startRecording(place, options?)",
            "Records what robots send, to a file that is not there yet, or to a folder. Options: {robots: [\"Nat*\"],"
                + " ports: [\"base.scan\"], compression: \"zstd\", splitBytes: 1e9, splitSeconds: 600}.",
            "the name of the file", call -> file(recorder.start(plan(call)))),
        ScriptFunction.of("stopRecording()", "Ends the recording.", "the names of its files",
            call -> files(recorder.stop())),
        ScriptFunction.of("recordingState()", "Says how the recording is doing.",
            "{recording, files, seconds, bytes, messages, dropped, diskLeft, problems, recentSeconds}",
            call -> described(recorder.state())),
        ScriptFunction.of("startFlightRecorder(seconds?, options?)",
            "Keeps the last seconds of what robots send (30, or as many) in memory. Options: {robots, ports}.", "",
            call -> done(recorder.keepRecent(call.seconds(0, USUAL_SECONDS), choice(options(call, CHOICE))))),
        ScriptFunction.of("stopFlightRecorder()", "Keeps the last seconds no more.", "", call -> {
          recorder.forgetRecent();
          return null;
        }),
        ScriptFunction.of("saveFlightRecorder(place)",
            "Writes the last seconds to a file that is not there yet, or to a folder.", "the name of the file",
            call -> file(recorder.saveRecent(Path.of(call.text(0))))));
  }

  private static RecordingPlan plan(ScriptCall call) throws ScriptFailure {
    Map<String, Object> options = options(call, ALL);
    try {
      return new RecordingPlan(Path.of(call.text(0)), choice(options), packing(options),
          number(options, "splitBytes").map(bytes -> OptionalLong.of(Math.round(bytes))).orElse(OptionalLong.empty()),
          number(options, "splitSeconds").map(seconds -> Duration.ofMillis(Math.round(seconds * 1000))));
    } catch (IllegalArgumentException e) {
      throw new ScriptFailure(e.getMessage());
    }
  }

  private static Map<String, Object> options(ScriptCall call, Set<String> known) throws ScriptFailure {
    Map<String, Object> options = call.fields(1);
    for (String name : options.keySet()) {
      if (!known.contains(name)) {
        throw new ScriptFailure(
            "there is no option '" + name + "'; there are " + String.join(", ", known.stream().sorted().toList()));
      }
    }
    return options;
  }

  private static RecordingChoice choice(Map<String, Object> options) throws ScriptFailure {
    return new RecordingChoice(names(options, ROBOTS), names(options, PORTS));
  }

  private static List<String> names(Map<String, Object> options, String name) throws ScriptFailure {
    Object value = options.get(name);
    if (value instanceof List<?> list && list.stream().allMatch(String.class::isInstance)) {
      return list.stream().map(String.class::cast).toList();
    }
    if (value == null || value instanceof String) {
      return value == null ? List.of() : List.of((String) value);
    }
    throw new ScriptFailure(name + " must be a list of names, such as [\"Nat*\"]");
  }

  private static Optional<Double> number(Map<String, Object> options, String name) throws ScriptFailure {
    Object value = options.get(name);
    if (value != null && !(value instanceof Number)) {
      throw new ScriptFailure(name + " must be a number");
    }
    return Optional.ofNullable(value).map(number -> ((Number) number).doubleValue());
  }

  private static RecordingPacking packing(Map<String, Object> options) throws ScriptFailure {
    Object word = options.getOrDefault("compression", "zstd");
    try {
      return RecordingPacking.valueOf(word.toString().toUpperCase(Locale.ROOT));
    } catch (IllegalArgumentException e) {
      throw new ScriptFailure("compression must be \"none\", \"lz4\" or \"zstd\", not \"" + word + "\"");
    }
  }

  private static List<String> files(RecordingOutcome outcome) throws ScriptFailure {
    return switch (outcome) {
      case RecordingOutcome.Done done -> done.files().stream().map(Path::toString).toList();
      case RecordingOutcome.Refused refused -> throw new ScriptFailure(refused.sentence());
    };
  }

  private static String file(RecordingOutcome outcome) throws ScriptFailure {
    return files(outcome).getLast();
  }

  private static Object done(RecordingOutcome outcome) throws ScriptFailure {
    files(outcome);
    return null;
  }

  private static Map<String, Object> described(RecorderState state) {
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("recording", state.recording().isPresent());
    Optional<RecordingStatus> status = state.recording().or(() -> state.ended().map(RecorderState.Ended::status));
    status.ifPresent(now -> {
      members.put("files", now.files().stream().map(Path::toString).toList());
      members.put("bytes", now.bytes());
      members.put("messages", now.messages());
      members.put("dropped", now.dropped());
      members.put("diskLeft", now.diskLeft());
      members.put("problems", now.problems());
    });
    state.recording().ifPresent(
        now -> members.put("seconds", (System.currentTimeMillis() - now.since().toEpochMilli()) / 1000.0));
    members.put("recentSeconds", state.recent().map(recent -> recent.kept().toMillis() / 1000.0).orElse(0.0));
    return members;
  }
}
