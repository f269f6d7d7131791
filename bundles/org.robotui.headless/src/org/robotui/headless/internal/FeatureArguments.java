package org.robotui.headless.internal;

import java.net.URI;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.robotui.headless.internal.Arguments.Wrong;

/**
 * What the command line wants of features.
 *
 * @param verb what is to be done
 * @param site the update site, to install from
 * @param features ids of features
 * @param unsigned true to install what nobody has signed without asking
 */
record FeatureArguments(Verb verb, Optional<URI> site, List<String> features, boolean unsigned) {
  static final String OPTION = "-features";
  static final String USAGE = """
      -features installed                       print what is installed and can be removed
      -features install -site URI [FEATURE...]  install from an update site, or print what it offers
      -features update [FEATURE...]             install newer versions
      -features remove FEATURE...               remove features
        -unsigned          install what nobody has signed without asking
        exit codes: 0 done, or there was nothing to do, 1 it was not done and nothing has changed
      """;

  /** What is done with features. */
  enum Verb {
    INSTALLED, INSTALL, UPDATE, REMOVE
  }

  static FeatureArguments parse(List<String> words) throws Wrong {
    List<String> features = new ArrayList<>();
    Optional<URI> site = Optional.empty();
    boolean unsigned = false;
    for (int at = 2; at < words.size(); at++) {
      switch (words.get(at)) {
        case "-site" -> site = Optional.of(uri(value(words, ++at)));
        case "-unsigned" -> unsigned = true;
        default -> features.add(words.get(at));
      }
    }
    Verb verb = verb(value(words, 1));
    if (verb == Verb.INSTALL && site.isEmpty()) {
      throw new Wrong(OPTION + " install needs -site URI");
    }
    if (verb == Verb.REMOVE && features.isEmpty()) {
      throw new Wrong(OPTION + " remove needs a feature; " + OPTION + " installed prints them");
    }
    return new FeatureArguments(verb, site, List.copyOf(features), unsigned);
  }

  private static Verb verb(String word) throws Wrong {
    return Arrays.stream(Verb.values()).filter(verb -> verb.name().equalsIgnoreCase(word)).findFirst()
        .orElseThrow(() -> new Wrong(OPTION + " is installed, install, update or remove, not '" + word + "'"));
  }

  private static String value(List<String> words, int at) throws Wrong {
    if (at >= words.size()) {
      throw new Wrong(words.getLast() + " needs a value");
    }
    return words.get(at);
  }

  private static URI uri(String text) throws Wrong {
    try {
      URI site = URI.create(text);
      if (site.isAbsolute()) {
        return site;
      }
    } catch (IllegalArgumentException e) {
      throw new Wrong("-site is no address of an update site: " + e.getMessage());
    }
    throw new Wrong("-site needs an address such as http://example.org/site or file:/path/to/site, not '" + text + "'");
  }
}
