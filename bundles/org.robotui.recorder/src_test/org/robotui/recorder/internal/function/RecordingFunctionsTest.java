package org.robotui.recorder.internal.function;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.script.ScriptCall;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;
import org.robotui.recorder.internal.file.RecorderCore;
import org.robotui.testkit.host.FakeHost;
import org.robotui.testkit.host.FakeRuic;

class RecordingFunctionsTest {
  private final FakeHost host = new FakeHost().add(new FakeRuic("Natalie"));
  private final RecorderCore recorder = new RecorderCore(host, "1");
  private final RecordingFunctions functions = new RecordingFunctions(recorder);
  private @TempDir Path folder;

  @AfterEach
  void end() {
    recorder.close();
  }

  /** What a script would call; the arguments are as the engine gives them. */
  private Object call(String name, Object... arguments) throws ScriptFailure, InterruptedException {
    ScriptFunction function =
        functions.functions().stream().filter(each -> each.name().equals(name)).findFirst().orElseThrow();
    ScriptCall call = (ScriptCall) Proxy.newProxyInstance(ScriptCall.class.getClassLoader(),
        new Class<?>[]{ScriptCall.class}, (proxy, method, given) -> {
          Optional<Object> value = (int) given[0] < arguments.length ? Optional.of(arguments[(int) given[0]])
              : Optional.empty();
          return switch (method.getName()) {
            case "text" -> value.orElseThrow();
            case "fields" -> value.orElse(Map.of());
            case "seconds" -> Duration.ofMillis(Math.round((double) value.orElse(given[1]) * 1000));
            default -> throw new UnsupportedOperationException(method.getName());
          };
        });
    return function.body().call(call);
  }

  @Test
  void aScriptRecords() throws Exception {
    Path file = folder.resolve("run.mcap");

    assertEquals(file.toString(), call("startRecording", file.toString(), Map.of("robots", List.of("Nat*"),
        "compression", "lz4", "splitBytes", 2e9)).toString().replace("_0001", ""));
    assertEquals(true, ((Map<?, ?>) call("recordingState")).get("recording"));
    assertTrue(call("stopRecording").toString().contains("run_0001.mcap"));
    assertEquals(false, ((Map<?, ?>) call("recordingState")).get("recording"));
  }

  @Test
  void theLastSecondsAreSaved() throws Exception {
    assertEquals("the last seconds are not kept; switch that on first", failure("saveFlightRecorder",
        folder.toString()));
    call("startFlightRecorder", 5.0);
    while (recorder.state().recent().orElseThrow().messages() == 0) {
      Thread.sleep(5);
    }

    assertTrue(Files.exists(Path.of((String) call("saveFlightRecorder", folder.toString()))));
    call("stopFlightRecorder");
    assertEquals(Optional.empty(), recorder.state().recent());
  }

  @Test
  void whatIsWrongIsToldToTheScript() {
    assertEquals("there is no option 'robot'; there are compression, ports, robots, splitBytes, splitSeconds",
        failure("startRecording", folder.toString(), Map.of("robot", "Natalie")));
    assertEquals("robots must be a list of names, such as [\"Nat*\"]",
        failure("startRecording", folder.toString(), Map.of("robots", 3.0)));
    assertEquals("compression must be \"none\", \"lz4\" or \"zstd\", not \"gzip\"",
        failure("startRecording", folder.toString(), Map.of("compression", "gzip")));
    assertEquals("nothing is recorded", failure("stopRecording"));
    assertTrue(failure("startFlightRecorder", 0.5).startsWith("the last seconds can be kept for 1 s to 10 minutes"));
  }

  private String failure(String name, Object... arguments) {
    return assertThrows(ScriptFailure.class, () -> call(name, arguments)).getMessage();
  }
}
