package org.robotui.lcm.internal.client;

import java.util.Set;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.internal.file.FileProvider;
import org.robotui.lcm.internal.memq.MemqLink;
import org.robotui.lcm.internal.tcpq.TcpqProvider;
import org.robotui.lcm.internal.udpm.UdpmProvider;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Finds the provider of a URL. */
final class Providers {

  private static final Logger LOG = LoggerFactory.getLogger(Providers.class);

  private Providers() {}

  static Provider of(LcmUrl url, LcmOptions options, Inlet inlet) {
    return switch (url.provider()) {
      case "udpm" -> known(url, UdpmProvider.OPTIONS, UdpmProvider.of(url, options, inlet));
      case "tcpq" -> known(url, Set.of(), TcpqProvider.of(url, options, inlet));
      case "file" -> known(url, FileProvider.OPTIONS, FileProvider.of(url, options, inlet));
      case "memq" -> known(url, Set.of(), () -> new MemqLink(inlet, options.partialBytes()));
      default -> throw new IllegalArgumentException("LCM has no provider '" + url.provider() + "' in '" + url
          + "'; take one of udpm, tcpq, file, memq, as in " + LcmUrl.DEFAULT);
    };
  }

  /** Other programs with the same URL may know more options, so it is not refused for one. */
  private static Provider known(LcmUrl url, Set<String> options, Provider provider) {
    url.options().keySet().stream().filter(option -> !options.contains(option))
        .forEach(option -> LOG.warn("the option '{}' of '{}' has no effect: {} knows {}", option, url, url.provider(),
            options));
    return provider;
  }
}
