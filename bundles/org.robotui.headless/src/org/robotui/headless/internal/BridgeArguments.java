package org.robotui.headless.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import org.robotui.api.input.Numerals;

/**
 * How bridges are run.
 *
 * @param metricsPort where their numbers can be asked for; none where they cannot
 * @param rest everything else that was said
 */
record BridgeArguments(OptionalInt metricsPort, Arguments rest) {
  static final String OPTION = "-bridge";
  static final String USAGE = """
      -bridge           run the bridges of the configurations, and print a line for each way of each of them
      -metrics PORT     give their numbers at http://127.0.0.1:PORT/metrics, as Prometheus reads them; 0: any free port, which is printed
      exit code 7: the configurations have no bridge, or the port is taken
      """;

  private static final int MOST = 65535;

  /** Wrong arguments, with a sentence for users, are those of {@link Arguments}. */
  static BridgeArguments parse(List<String> words) throws Arguments.Wrong {
    List<String> rest = new ArrayList<>();
    OptionalInt port = OptionalInt.empty();
    for (int i = 0; i < words.size(); i++) {
      switch (words.get(i)) {
        case OPTION -> {
          // what is left says what is to be bridged
        }
        case "-metrics" -> port = OptionalInt.of(port(i + 1 < words.size() ? words.get(++i) : ""));
        default -> rest.add(words.get(i));
      }
    }
    return new BridgeArguments(port, Arguments.parse(rest.toArray(String[]::new)));
  }

  private static int port(String text) throws Arguments.Wrong {
    return Numerals.whole(text).filter(n -> n.signum() >= 0 && n.bitLength() < Integer.SIZE && n.intValue() <= MOST)
        .orElseThrow(() -> new Arguments.Wrong("-metrics needs a port from 0 to " + MOST + ", not '" + text + "'"))
        .intValue();
  }
}
