package org.robotui.core.internal.fence;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A foreign browser: what it throws is told to the view that asks as a failed answer with its origin, so that nobody
 * takes the view for the one that failed.
 *
 * @param browser the foreign one
 * @param origin names bundle and class
 */
public record FencedBrowser(Browser browser, Supplier<String> origin) implements Browser {
  private static final Logger LOG = LoggerFactory.getLogger(FencedBrowser.class);

  @FunctionalInterface
  private interface Question<T> {
    T ask() throws CallException;
  }

  private <T> T fenced(Question<T> question) throws CallException {
    try {
      return question.ask();
    } catch (RuntimeException | Error e) { // foreign code may throw anything
      Thrown.log(LOG, "A robot interface failed to answer", e);
      throw new CallException("the robot interface failed: " + Thrown.text(e) + " (" + origin.get() + ")");
    }
  }

  @Override
  public List<Item> list(Kind kind) throws CallException {
    return fenced(() -> browser.list(kind));
  }

  @Override
  public Description describe(Item item) throws CallException {
    return fenced(() -> browser.describe(item));
  }

  @Override
  public Optional<Object> parameter(String name) throws CallException {
    return fenced(() -> browser.parameter(name));
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    fenced(() -> {
      browser.setParameter(name, value);
      return name;
    });
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    return fenced(() -> browser.tunables(item));
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    return fenced(() -> browser.setTunables(item, values));
  }

  @Override
  public List<Link> links() throws CallException {
    return fenced(browser::links);
  }
}
