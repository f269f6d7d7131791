package org.robotui.rtps;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.Executors;

/**
 * A process of its own that listens to a topic, to be stopped and killed. Arguments: the domain, and how it listens:
 * adapting or reliable. It prints a line when it is matched, and at the end of its input how many samples it had.
 */
final class Workbench implements AutoCloseable {

  private final Process process;

  private Workbench(Process process) {
    this.process = process;
  }

  public static void main(String[] arguments) throws IOException, InterruptedException {
    ParticipantSettings settings =
        ParticipantSettings.standard(Integer.parseInt(arguments[0]), "workbench").withPeers(false, List.of());
    Heard heard = new Heard();
    Qos qos = Qos.reliable(100);
    try (Participant us = Participant.open(settings, Executors.defaultThreadFactory())) {
      Reader reader = arguments[1].equals("adapting")
          ? us.adaptingReader("rt/from_peer", Heard.TYPE, qos, Heard.NOTHING, heard)
          : us.reader("rt/from_peer", Heard.TYPE, qos, Heard.NOTHING, heard);
      Heard.await(Duration.ofSeconds(30), () -> !reader.matched().isEmpty(), () -> "nobody is there");
      Heard.await(Duration.ofSeconds(30), () -> heard.samples().size() > 5, () -> "nothing is heard");
      System.out.println("matched");
      while (System.in.read() >= 0) {
        // until the end
      }
    }
  }

  /** Starts one, and waits until it is matched. */
  static Workbench start(int domain, String how) throws IOException {
    Process process = new ProcessBuilder(ProcessHandle.current().info().command().orElse("java"), "-Xmx256m", "-cp",
        System.getProperty("java.class.path"), Workbench.class.getName(), "" + domain, how)
        .redirectError(ProcessBuilder.Redirect.DISCARD).start();
    for (String line = ""; !"matched".equals(line); line = process.inputReader().readLine()) {
      if (line == null) {
        throw new IOException("it ended by itself");
      }
    }
    return new Workbench(process);
  }

  /** Stops it as Ctrl+Z does, or lets it go on. */
  void signal(String name) throws IOException, InterruptedException {
    new ProcessBuilder("kill", "-" + name, "" + process.pid()).start().waitFor();
  }

  @Override
  public void close() throws IOException, InterruptedException {
    process.destroyForcibly().waitFor();
  }
}
