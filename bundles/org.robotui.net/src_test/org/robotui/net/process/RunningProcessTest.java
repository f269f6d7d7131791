package org.robotui.net.process;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;

class RunningProcessTest {

  @Test
  void thisOneRuns() {
    assertTrue(RunningProcess.current().runs());
  }

  @Test
  void anotherOneOfTheSameNumberIsNotTheSame() {
    RunningProcess current = RunningProcess.current();
    assertFalse(new RunningProcess(current.pid(), current.started().minus(Duration.ofMinutes(1))).runs());
  }

  @Test
  void oneThatEndedDoesNotRunThoughNobodyHasAskedForItsEnd() throws IOException, InterruptedException {
    Assumptions.assumeTrue(Files.isDirectory(Path.of("/proc/self")), "only Linux tells the state of a process");
    // The program that replaces the shell never asks how the shell's child ended.
    Process parent = new ProcessBuilder("sh", "-c", "sleep 60 & echo $!; exec sleep 60").start();
    try (BufferedReader out = parent.inputReader(StandardCharsets.UTF_8)) {
      long pid = Long.parseLong(out.readLine());
      ProcessHandle child = ProcessHandle.of(pid).orElseThrow();
      RunningProcess process = new RunningProcess(pid, child.info().startInstant().orElse(Instant.EPOCH));
      assertTrue(process.runs());
      while (!parent.info().command().orElse("").endsWith("sleep")) {
        Thread.onSpinWait();
      }
      child.destroyForcibly();
      while (process.runs()) {
        Thread.onSpinWait();
      }
      assertTrue(child.isAlive(), "the system has forgotten it already: this shows nothing");
    } finally {
      parent.destroyForcibly().waitFor();
    }
  }
}
