package org.robotui.uic.graph.internal.model;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.robotui.uic.graph.internal.model.Wiring.Tie;

/** Leaves out what is not wanted. Pure. */
final class Sieve {
  private static final Pattern TOOLS = Pattern.compile(
      "/(.*/)?(rosout|rviz\\w*|rqt\\w*|rosapi|rosbridge\\w*|rostopic_\\w*|record_\\w*|play_\\w*|robotui\\w*|diag_agg|runtime_logger)");
  private static final Pattern TOOL_TOPICS = Pattern.compile(
      "/(.*/)?(rosout|rosout_agg|statistics|clock|parameter_updates|parameter_descriptions|bond)");
  private static final Pattern TF = Pattern.compile("/(.*/)?tf(_static)?");

  private Sieve() {}

  static List<Tie> sift(List<Tie> ties, Ask ask) {
    List<Tie> left =
        keep(ties, tie -> !(ask.tools() && (matches(TOOLS, tie.node()) || matches(TOOL_TOPICS, tie.topic())))
            && !(ask.tf() && matches(TF, tie.topic())));
    if (ask.ends()) {
      Set<Vertex> sent = topics(left, true);
      Set<Vertex> taken = topics(left, false);
      List<Tie> through = keep(left, tie -> sent.contains(tie.topic()) && taken.contains(tie.topic()));
      // A robot that is one node has dead ends alone: better those than nothing.
      left = through.isEmpty() ? left : through;
    }
    return ask.words().isEmpty() ? left : found(left, ask.words());
  }

  /**
   * What has the words, and what is wired to it: of a node its topics and those at their other ends, of a topic its
   * nodes.
   */
  private static List<Tie> found(List<Tie> ties, List<String> words) {
    Set<Vertex> hits = new HashSet<>();
    ties.forEach(tie -> {
      if (fits(tie.node(), words)) {
        hits.add(tie.node());
        hits.add(tie.topic());
      } else if (fits(tie.topic(), words)) {
        hits.add(tie.topic());
      }
    });
    return keep(ties, tie -> hits.contains(tie.topic()));
  }

  private static boolean fits(Vertex vertex, List<String> words) {
    String name = (vertex.robot() + vertex.name()).toLowerCase(Locale.ROOT);
    return words.stream().allMatch(name::contains);
  }

  private static Set<Vertex> topics(List<Tie> ties, boolean sent) {
    return ties.stream().filter(tie -> tie.sends() == sent).map(Tie::topic).collect(Collectors.toSet());
  }

  private static boolean matches(Pattern pattern, Vertex vertex) {
    return pattern.matcher(vertex.name()).matches();
  }

  private static List<Tie> keep(List<Tie> ties, Predicate<Tie> wanted) {
    return ties.stream().filter(wanted).toList();
  }
}
