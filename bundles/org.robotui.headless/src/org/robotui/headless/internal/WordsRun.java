package org.robotui.headless.internal;

import java.io.PrintStream;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.robotui.api.UicType.Surface;
import org.robotui.api.command.Principal;
import org.robotui.api.config.Schema;
import org.robotui.api.host.Host;
import org.robotui.api.host.Installed;
import org.robotui.api.host.SettingsGroup.Part;
import org.robotui.headless.internal.WordsPrinter.Described;

/** Prints what configurations can say, from the schemas by which they are checked. */
final class WordsRun {
  static final String SAFETY = "safety";

  private static final Principal NOBODY = new Principal("words", "Words", Principal.Kind.SCRIPT);
  private static final Duration LOOK = Duration.ofMillis(100);
  /** Types of components may still be on their way when the application starts. */
  private static final Duration TYPES = Duration.ofSeconds(5);
  private static final Duration CLOSE_LIMIT = Duration.ofMillis(1800);
  /** So often nothing new came. */
  private static final int SETTLED = 5;

  private final Host host;
  private final PrintStream out;
  private final PrintStream err;

  WordsRun(Host host, PrintStream out, PrintStream err) {
    this.host = host;
    this.out = out;
    this.err = err;
  }

  Exit run(WordsArguments wanted) throws InterruptedException {
    host.open(Surface.WINDOW, NOBODY);
    try {
      return print(wanted, all(settled()));
    } finally {
      host.close(CLOSE_LIMIT);
    }
  }

  private Exit print(WordsArguments wanted, List<Described> all) {
    WordsPrinter printer = new WordsPrinter(out, wanted.json());
    if (wanted.types().isEmpty()) {
      printer.list(all);
      return Exit.FINE;
    }
    for (String type : wanted.types()) {
      List<Described> found = all.stream().filter(d -> d.id().equals(type)).toList();
      if (found.isEmpty()) {
        err.println("there is no type '" + type + "'; there are "
            + String.join(", ", all.stream().map(Described::id).distinct().toList()));
        return Exit.ERRORS;
      }
      found.forEach(printer::print);
    }
    return Exit.FINE;
  }

  private List<Described> all(List<Installed> types) {
    List<Described> all = new ArrayList<>();
    types.stream().sorted(Comparator.comparing(Installed::kind).thenComparing(t -> t.descriptor().id()))
        .forEach(type -> all.add(described(type)));
    all.add(new Described("safety", SAFETY, "Safety", "How a robot is kept safe, in the section 'safety' by its name.",
        host.settings().always(Part.SAFETY), List.of()));
    return all;
  }

  private Described described(Installed type) {
    Part part = switch (type.kind()) {
      case RFIC -> Part.INTERFACE;
      case UIC -> Part.VIEW;
      case RUIC -> Part.RUIC;
    };
    String kind = switch (type.kind()) {
      case RFIC -> "robot interface";
      case UIC -> "view";
      case RUIC -> "robot UI";
    };
    Schema schema = new Schema(Stream.concat(type.descriptor().schema().settings().stream(),
        host.settings().always(part).settings().stream()).toList());
    return new Described(kind, type.descriptor().id(), type.descriptor().label(), type.descriptor().help(), schema,
        type.descriptor().ports());
  }

  private List<Installed> settled() throws InterruptedException {
    long end = System.nanoTime() + TYPES.toNanos();
    List<Installed> found = host.installed();
    int same = 0;
    while ((same < SETTLED || found.isEmpty()) && System.nanoTime() < end) {
      Thread.sleep(LOOK);
      List<Installed> next = host.installed();
      same = next.size() == found.size() ? same + 1 : 0;
      found = next;
    }
    return found;
  }
}
