package org.robotui.uic.connections.internal.model;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;

/** How everything is doing, in a line. */
final class Summary {
  private Summary() {}

  /** For example {@code 12 links: 10 connected, 1 degraded, 1 failed; 3 ports need a decision}. */
  static String of(List<RuicSnapshot> ruics) {
    List<String> links = ruics.stream().flatMap(ruic -> ruic.components().stream())
        .filter(component -> component.kind() == ComponentStatus.Kind.RFIC).map(Summary::word).toList();
    return Stream.of(links(links), decisions(ruics), unconnected(ruics)).filter(part -> !part.isEmpty())
        .collect(Collectors.joining("; "));
  }

  private static String links(List<String> words) {
    String states = Stream.of("connected", "degraded", "connecting", "disconnected", "not started", "failed")
        .map(word -> count(words, word)).filter(part -> !part.isEmpty()).collect(Collectors.joining(", "));
    return counted(words.size(), "link", "links") + (states.isEmpty() ? "" : ": " + states);
  }

  private static String count(List<String> words, String word) {
    long count = words.stream().filter(word::equals).count();
    return count == 0 ? "" : count + " " + word;
  }

  private static String word(ComponentStatus component) {
    if (component.state() == RuicState.ADDED) {
      return "not started";
    }
    return component.state() == RuicState.FAILED ? "failed"
        : component.link().map(Summary::word).orElse("disconnected");
  }

  /** The word of the kind of state: that of a failed link counts down. */
  private static String word(LinkState link) {
    return link instanceof LinkState.Failed ? "failed" : link.word();
  }

  private static String decisions(List<RuicSnapshot> ruics) {
    long count = lines(ruics).filter(line -> line.decision().isPresent()).count();
    return count == 0 ? "" : counted(count, "port needs a decision", "ports need a decision");
  }

  private static String unconnected(List<RuicSnapshot> ruics) {
    long count = lines(ruics).filter(line -> line.isProblem() && line.decision().isEmpty()).count();
    return count == 0 ? "" : counted(count, "view port is not connected", "view ports are not connected");
  }

  private static Stream<ConnectionLine.ViewPort> lines(List<RuicSnapshot> ruics) {
    return ruics.stream()
        .flatMap(ruic -> ruic.matches().stream().map(match -> new ConnectionLine.ViewPort(ruic.name(), match)));
  }

  private static String counted(long count, String one, String many) {
    return count + " " + (count == 1 ? one : many);
  }
}
