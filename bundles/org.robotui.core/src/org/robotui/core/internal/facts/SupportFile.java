package org.robotui.core.internal.facts;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.UserFolder;
import org.robotui.net.process.SocketAnswer;

/**
 * Everything that somebody needs to know who helps, in one file that only its user can read.
 *
 * @param state the folder of what is kept
 * @param home where the product lies, if that is known
 */
public record SupportFile(Path state, Optional<Path> home) {
  private static final Duration LIMIT = Duration.ofSeconds(5);
  private static final int MOST_LOGS = 12;
  private static final int MOST_OTHERS = 60;
  private static final String HEAD = """
      What RobotUI knew about itself when help was asked for, %s.

      Read it before you give it away. Values whose names say that they are secret (password, token, key and the like), \
      names and passwords in addresses, and private keys are masked by ***. Names of robots, machines, users and files, \
      addresses of robots, and what their programs have logged are in here as they are. No picture, no recorded data and \
      nothing of what robots send is in here but what was logged.
      """;

  /**
   * Writes it. Blocks: reads and writes files, and asks the other processes of this user.
   *
   * @param file is replaced where it exists
   * @param configurations the files that shall be in it, beside those that running processes have loaded
   * @param own texts of this process by the names of their files
   * @return what is in it, a line each
   * @throws IOException where it cannot be written
   */
  public List<String> write(Path file, Collection<Path> configurations, Map<String, String> own) throws IOException {
    AtomicReference<List<String>> contents = new AtomicReference<>(List.of());
    AtomicFile.writePrivate(file, out -> {
      FactsZip zip = new FactsZip(out);
      zip.text("machine.txt", "the machine, and variables of the environment", MachineFacts.text(state));
      for (Map.Entry<String, String> text : own.entrySet()) {
        zip.text(text.getKey(), "of the process that has written this", text.getValue());
      }
      Set<Path> files = new LinkedHashSet<>(configurations);
      files.addAll(running(zip));
      configurations(zip, files);
      kept(zip);
      product(zip);
      contents.set(zip.finish(HEAD.formatted(Instant.now())));
    });
    return contents.get();
  }

  /** The other processes say of themselves what this one does of itself. */
  private Set<Path> running(FactsZip zip) throws IOException {
    Set<Path> configurations = new LinkedHashSet<>();
    String self = Long.toString(ProcessHandle.current().pid());
    for (SocketAnswer answer : SocketAnswer.ask(UserFolder.sockets(state), "stop-*.sock", "facts", LIMIT)) {
      if (!answer.process().equals(self)) {
        String text = answer.text().isEmpty() ? "It runs, and has not answered within " + LIMIT.toSeconds() + " s."
            : answer.text();
        zip.text("running-" + answer.process() + ".txt",
            "the RobotUI that runs as process " + answer.process() + ": versions, memory, robots, bundles, threads",
            text);
        configurations.addAll(ProcessFacts.configurationsOf(text));
      }
    }
    return configurations;
  }

  private static void configurations(FactsZip zip, Set<Path> files) throws IOException {
    int number = 0;
    for (Path file : files) {
      number++;
      zip.file("configurations/" + number + "-" + file.getFileName(), "the configuration " + file, file);
    }
  }

  private void kept(FactsZip zip) throws IOException {
    KeptFiles files = new KeptFiles(state);
    zip.text("state.txt", "the files in " + state, files.list());
    add(zip, files.matching(MOST_LOGS, "workspace-*/robotui.log*"), "a log");
    add(zip, files.matching(MOST_LOGS, "workspace-*/crash-*.log", "workspace-*/.metadata/.log"),
        "what the virtual machine or the platform said of a failure");
    add(zip,
        files.matching(MOST_OTHERS, "overlays/*", "alerts/*", "perspectives/*", "run/*.txt", "*.txt", "*.properties",
            "*.yaml"),
        "what was kept from one run to the next");
  }

  private void add(FactsZip zip, List<Path> files, String what) throws IOException {
    for (Path file : files) {
      zip.file("state/" + state.relativize(file).toString().replace('\\', '/'), what, file);
    }
  }

  private void product(FactsZip zip) throws IOException {
    if (home.isEmpty()) {
      return;
    }
    Path configuration = home.get().resolve("configuration");
    zip.file("product/bundles.info", "the bundles that the product starts with",
        configuration.resolve("org.eclipse.equinox.simpleconfigurator").resolve("bundles.info"));
    zip.file("product/eclipse.ini", "with which arguments it starts", home.get().resolve("eclipse.ini"));
    for (Path log : new KeptFiles(configuration).matching(MOST_LOGS, "*.log")) {
      zip.file("product/" + log.getFileName(), "what the framework said of a failure", log);
    }
  }
}
