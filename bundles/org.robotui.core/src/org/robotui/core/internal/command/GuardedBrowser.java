package org.robotui.core.internal.command;

import java.util.List;
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
    Optional<Refused> refused = arbiter.notAllowed(principal);
    if (refused.isPresent()) {
      throw new CallException(refused.get().explanation());
    }
    browser.setParameter(name, value);
  }
}
