package org.robotui.testkit.rfic;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** All that every robot interface keeps. */
public final class RficContract {
  private RficContract() {}

  /**
   * The checks, each with a robot and a robot interface of its own.
   *
   * @param peers makes a robot that is away
   * @return the checks in an order for readers, those as well that the framework is lacking something for
   */
  public static Stream<Check> of(Supplier<? extends Peer> peers) {
    Map<Capability, String> lacks = lacks(peers);
    return Stream.of(LinkClauses.all(), DataClauses.all(), CommandClauses.all(), FaultClauses.all(), EndClauses.all())
        .flatMap(List::stream).map(clause -> check(clause, lacks, peers));
  }

  private static Map<Capability, String> lacks(Supplier<? extends Peer> peers) {
    try (Peer peer = peers.get()) {
      return peer.lacks();
    }
  }

  private static Check check(Clause clause, Map<Capability, String> lacks, Supplier<? extends Peer> peers) {
    String reasons =
        clause.needs().stream().filter(lacks::containsKey).map(lacks::get).collect(Collectors.joining("; "));
    return new Check(clause.name(), Optional.of(reasons).filter(r -> !r.isEmpty()), () -> clause.body().run(peers));
  }
}
