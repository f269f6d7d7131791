package org.robotui.headless.internal;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.api.host.Host;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Ruic;

/** A terminal shows all robots at once: each RUIC that comes is selected, in a window of its own. */
final class Selector implements HostListener, AutoCloseable {
  private final Host host;
  private final Set<String> selected = ConcurrentHashMap.newKeySet();
  private final Host.Subscription subscription;

  Selector(Host host) {
    this.host = host;
    subscription = host.listen(this);
    ruicsChanged();
  }

  @Override
  public void ruicsChanged() {
    for (Ruic ruic : host.ruics()) {
      if (selected.add(ruic.name())) {
        ruic.select("terminal/" + ruic.name());
      }
    }
    selected.retainAll(host.ruics().stream().map(Ruic::name).toList());
  }

  @Override
  public void close() {
    subscription.close();
  }
}
