package org.robotui.headless.internal;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.api.host.Host;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Ruic;

/**
 * A terminal shows all robots at once: each RUIC that comes is selected, in a window of its own. Those that start only
 * when they are shown are shown where they were asked for.
 */
final class Selector implements HostListener, AutoCloseable {
  private final Host host;
  private final Set<String> wanted;
  private final Set<String> selected = ConcurrentHashMap.newKeySet();
  private final Host.Subscription subscription;

  Selector(Host host, Set<String> wanted) {
    this.host = host;
    this.wanted = Set.copyOf(wanted);
    subscription = host.listen(this);
    ruicsChanged();
  }

  @Override
  public void ruicsChanged() {
    for (Ruic ruic : host.ruics()) {
      if ((!ruic.startsShown() || wanted.contains(ruic.name())) && selected.add(ruic.name())) {
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
