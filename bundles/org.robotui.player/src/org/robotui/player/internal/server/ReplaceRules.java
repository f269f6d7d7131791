package org.robotui.player.internal.server;

import java.util.ArrayList;
import java.util.List;
import org.robotui.player.interfaces.Server;
import org.robotui.player.wire.PlayerMessage;

/**
 * What a client wants to become of data while others of their kind wait; the last rule that fits counts. Not for many
 * threads.
 */
final class ReplaceRules {

  /** What becomes of a message. */
  enum Verdict {
    /** It waits behind the others. */
    ACCEPT,
    /** It takes the place of an older one. */
    REPLACE,
    /** It is not sent. */
    IGNORE
  }

  private static final int ANY = -1;
  private static final int MOST = 64;

  private final List<Server.ReplaceRule> rules = new ArrayList<>();

  /** Adds a rule; false if there are too many, or it is none. */
  boolean add(Server.ReplaceRule rule) {
    return rules.size() < MOST && rule.replace() >= 0 && rule.replace() < Verdict.values().length && rules.add(rule);
  }

  Verdict of(PlayerMessage message) {
    for (Server.ReplaceRule rule : rules.reversed()) {
      if (fits(rule.interfaceCode(), message.device().interfaceCode()) && fits(rule.index(), message.device().index())
          && fits(rule.type(), message.type().code()) && fits(rule.subtype(), message.subtype())) {
        return Verdict.values()[rule.replace()];
      }
    }
    return Verdict.ACCEPT;
  }

  private static boolean fits(int wanted, int given) {
    return wanted == ANY || wanted == given;
  }
}
