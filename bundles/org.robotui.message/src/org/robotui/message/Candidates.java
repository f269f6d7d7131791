package org.robotui.message;

import java.util.Optional;
import java.util.function.Function;

/** Takes the first candidate with the wanted sum, and remembers why the others did not do. */
final class Candidates<S> {

  /** Where a candidate comes from. */
  @FunctionalInterface
  interface Source<S> {
    Optional<S> find() throws DefinitionException;
  }

  private final String kind;
  private final MessageInfo wanted;
  private Optional<S> found = Optional.empty();
  private String reason = "";

  Candidates(String kind, String type, String md5) {
    this.kind = kind;
    this.wanted = new MessageInfo(type, md5, "");
  }

  void add(Source<S> source, Function<S, String> md5) {
    if (found.isPresent()) {
      return;
    }
    try {
      source.find().ifPresent(each -> judge(each, md5.apply(each)));
    } catch (DefinitionException e) {
      reason = e.getMessage();
    }
  }

  private void judge(S candidate, String md5) {
    if (wanted.accepts(md5)) {
      found = Optional.of(candidate);
    } else {
      reason = "the robot's " + wanted.type() + " has the sum " + wanted.md5() + ", the one known here " + md5
          + ": the definitions differ";
    }
  }

  SchemaLookup<S> result() {
    if (found.isPresent()) {
      return new SchemaLookup.Found<>(found.get());
    }
    String missing = "no definition of the " + kind + " type " + wanted.type()
        + " is shipped, installed on this machine (ROS_PACKAGE_PATH, /usr/share) or learned from a peer";
    return new SchemaLookup.Missing<>(reason.isEmpty() ? missing : reason);
  }
}
