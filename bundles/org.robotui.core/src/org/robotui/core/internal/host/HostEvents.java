package org.robotui.core.internal.host;

import java.util.List;
import java.util.function.Consumer;
import org.robotui.api.host.ConfigChange;
import org.robotui.api.show.Subject;
import org.robotui.core.internal.life.Events;
import org.robotui.core.internal.life.RuicRuntime;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Passes on what happens to listeners; what the user should know goes to the log as well. */
final class HostEvents implements Events {
  private static final Logger LOG = LoggerFactory.getLogger(HostEvents.class);

  private final Notifier notifier;
  private final Consumer<RuicRuntime> removed;

  HostEvents(Notifier notifier, Consumer<RuicRuntime> removed) {
    this.notifier = notifier;
    this.removed = removed;
  }

  /** A file that was loaded has changed. */
  void configurationChanged(ConfigChange change) {
    change.problems().forEach(p -> LOG.warn("{}", p));
    change.steps().forEach(s -> LOG.info("{} was changed: {}", change.file(), s));
    notifier.post(List.of("configuration", change), l -> l.configurationChanged(change));
  }

  void ruicsChanged() {
    notifier.post("ruics", l -> l.ruicsChanged());
  }

  @Override
  public void changed(String ruic) {
    notifier.post(List.of("changed", ruic), l -> l.ruicChanged(ruic));
  }

  @Override
  public void frameReady(String ruic, String uic) {
    notifier.post(List.of("frame", ruic, uic), l -> l.frameReady(ruic, uic));
  }

  @Override
  public void showWanted(String from, String wanted) {
    notifier.post(List.of("show", from, wanted), l -> l.showWanted(from, wanted));
  }

  @Override
  public void viewWanted(String ruic, String uic, String showing, Subject subject) {
    notifier.post(List.of("view", ruic, uic, showing, subject), l -> l.viewWanted(ruic, uic, showing, subject));
  }

  @Override
  public void alert(String ruic, String message) {
    LOG.warn("{}{}", ruic.isEmpty() ? "" : ruic + ": ", message);
    notifier.post(List.of("alert", ruic, message), l -> l.alert(ruic, message));
  }

  /** Something about the application that soon is over. */
  void notice(String message) {
    LOG.warn("{}", message);
    notifier.post(List.of("notice", message), l -> l.notice(message));
  }

  @Override
  public void removed(RuicRuntime ruic) {
    removed.accept(ruic);
    ruicsChanged();
  }
}
