package org.robotui.bridge.internal.far;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.command.Authority;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;

/** A parameter of a robot. Setting it needs the lease like a command. Safe for all threads. */
public final class HeldParameter {
  private static final String SLASH = "/";

  private final BridgeEnd end;
  private final Ruic ruic;
  private final PortAccess access;
  private final ControlClaim control;
  private volatile Optional<String> known = Optional.empty();

  /** Closes neither. */
  public HeldParameter(BridgeEnd end, Ruic ruic, PortAccess access) {
    this.end = end;
    this.ruic = ruic;
    this.access = access;
    this.control = new ControlClaim(access.principal());
  }

  /** Why the robot cannot be asked for parameters now. */
  public Optional<String> missing() {
    return NamedItem.browser(end, ruic, access).isPresent() ? Optional.empty() : Optional.of(absent());
  }

  private String absent() {
    return "'" + end.ruic() + "." + end.port().component() + "' cannot be asked for parameters now";
  }

  private Browser browser() throws CallException {
    return NamedItem.browser(end, ruic, access).orElseThrow(() -> new CallException(absent()));
  }

  /**
   * Its value; none where it is not set. Blocks.
   *
   * @throws CallException where the robot does not answer
   */
  public Optional<Object> value() throws CallException {
    Browser browser = browser();
    return browser.parameter(whole(browser));
  }

  /** The names of some frameworks begin with a slash, which ends of bridges have not. */
  private String whole(Browser browser) throws CallException {
    Optional<String> before = known;
    if (before.isPresent()) {
      return before.get();
    }
    String bare = end.port().port();
    List<String> names = browser.list(Browser.Kind.PARAMETER).stream().map(Browser.Item::name).toList();
    known = Stream.of(SLASH + bare, bare).filter(names::contains).findFirst();
    return known.orElse(names.stream().anyMatch(name -> name.startsWith(SLASH)) ? SLASH + bare : bare);
  }

  /**
   * Sets it. Blocks.
   *
   * @throws CallException where the robot must not be commanded now, does not answer or refuses, with the reason
   */
  public void set(Object value) throws CallException {
    Optional<String> obstacle = obstacle();
    if (obstacle.isPresent()) {
      throw new CallException(obstacle.get());
    }
    Browser browser = browser();
    browser.setParameter(whole(browser), value);
  }

  private synchronized Optional<String> obstacle() {
    Optional<Authority> authority = authority();
    return authority.isEmpty() ? Optional.of("the robot of " + end + " is not there")
        : control.obstacle(authority.get(), true, System.nanoTime());
  }

  private Optional<Authority> authority() {
    return ruic.authority(end.port().component());
  }

  /** Who has control of the robot. */
  public Optional<String> holder() {
    return authority().flatMap(Authority::holder).map(holder -> holder.label());
  }

  /** Gives the lease back where nothing is set. */
  public synchronized void tick(long now) {
    control.tick(authority(), now);
  }

  /** Gives the lease back. */
  public synchronized void close() {
    authority().ifPresent(control::giveBack);
  }
}
