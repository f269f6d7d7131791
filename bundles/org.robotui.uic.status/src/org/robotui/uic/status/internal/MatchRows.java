package org.robotui.uic.status.internal;

import org.robotui.api.host.Match;
import org.robotui.ui.MatchLook;
import org.robotui.ui.Role;

/** Lines of connections. */
final class MatchRows {
  private MatchRows() {}

  static StatusRow note(Match match) {
    return new StatusRow.Note("note " + match.kind() + " " + match.port(), Role.WARNING,
        match.port() + ": " + match.reason());
  }

  static StatusRow of(Match match) {
    return new StatusRow.Said("match " + match.kind() + " " + match.port(), MatchLook.health(match),
        match.port().toString(),
        MatchLook.word(match), MatchLook.text(match), MatchLook.details(match));
  }
}
