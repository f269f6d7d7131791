package org.robotui.core.internal.command;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.command.CommandOutcome.Refused;
import org.robotui.api.command.Principal;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;

/** A browser that sets parameters only for those who may command the robot. */
public record GuardedBrowser(Browser browser, Arbiter arbiter, Principal principal) implements Browser {
  @Override
  public List<Item> list(Kind kind) throws CallException {
    return browser.list(kind);
  }

  @Override
  public Description describe(Item item) throws CallException {
    return browser.describe(item);
  }

  @Override
  public Optional<Object> parameter(String name) throws CallException {
    return browser.parameter(name);
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    check();
    browser.setParameter(name, value);
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    return browser.tunables(item);
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    check();
    return browser.setTunables(item, values);
  }

  @Override
  public List<Link> links() throws CallException {
    return browser.links();
  }

  private void check() throws CallException {
    Optional<Refused> refused = arbiter.notAllowed(principal);
    if (refused.isPresent()) {
      throw new CallException(refused.get().explanation());
    }
  }
}
