package org.robotui.lcm.internal.udpm;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.internal.client.Inlet;
import org.robotui.lcm.internal.client.Link;
import org.robotui.lcm.internal.client.Provider;

/** UDP multicast, as a URL describes it. */
public final class UdpmProvider implements Provider {

  /** What a URL may say. */
  public static final Set<String> OPTIONS = Set.of("ttl", "recv_buf_size", "interface");

  private static final String STANDARD = "239.255.76.67:7667";
  private static final Pattern ADDRESS = Pattern.compile("(\\d{1,3}(?:\\.\\d{1,3}){3})(?::(\\d{1,5}))?");

  private final LcmUrl url;
  private final InetSocketAddress group;
  private final int ttl;
  private final int receiveBuffer;
  private final Optional<String> networkInterface;
  private final LcmOptions options;
  private final Inlet inlet;

  private UdpmProvider(LcmUrl url, LcmOptions options, Inlet inlet) {
    this.url = url;
    this.group = group(url);
    this.ttl = number(url, "ttl", 0, 255).orElse(0);
    this.receiveBuffer = number(url, "recv_buf_size", 1, Integer.MAX_VALUE / 4).orElse(options.receiveBuffer());
    this.networkInterface = Optional.ofNullable(url.options().get("interface"));
    this.options = options;
    this.inlet = inlet;
  }

  public static UdpmProvider of(LcmUrl url, LcmOptions options, Inlet inlet) {
    return new UdpmProvider(url, options, inlet);
  }

  private static InetSocketAddress group(LcmUrl url) {
    Matcher address = ADDRESS.matcher(url.network().isEmpty() ? STANDARD : url.network());
    try {
      int port = address.matches() ? Integer.parseInt(Optional.ofNullable(address.group(2)).orElse("7667")) : 0;
      if (port > 0 && port <= 65535 && InetAddress.getByName(address.group(1)) instanceof Inet4Address group
          && group.isMulticastAddress()) {
        return new InetSocketAddress(group, port);
      }
    } catch (UnknownHostException e) {
      throw wrong(url, "'" + url.network() + "' is no address", e);
    }
    throw wrong(url, "'" + url.network() + "' is no multicast address with a port", null);
  }

  private static Optional<Integer> number(LcmUrl url, String option, int least, int most) {
    String text = url.options().get(option);
    if (text == null) {
      return Optional.empty();
    }
    if (!text.matches("\\d{1,9}") || Integer.parseInt(text) < least || Integer.parseInt(text) > most) {
      throw wrong(url, option + "=" + text + " is no number from " + least + " to " + most, null);
    }
    return Optional.of(Integer.valueOf(text));
  }

  private static IllegalArgumentException wrong(LcmUrl url, String problem, Exception cause) {
    return new IllegalArgumentException(
        "'" + url + "': " + problem + "; write for example udpm://" + STANDARD + "?ttl=1", cause);
  }

  @Override
  public Link open() throws IOException {
    Interfaces.Choice choice = Interfaces.choose(group, networkInterface, ttl);
    try {
      UdpmLink link = UdpmLink.open(group, choice.networkInterface(), ttl, receiveBuffer, options, inlet);
      inlet.counters().receiveBuffer(receiveBuffer, link.receiveBuffer());
      return link;
    } catch (IOException e) {
      throw new IOException(
          "cannot join " + url + " on " + choice.networkInterface().getName() + ": " + e.getMessage() + choice.advice(),
          e);
    }
  }
}
