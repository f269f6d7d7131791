package org.robotui.install.internal;

import java.security.cert.Certificate;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import org.bouncycastle.openpgp.PGPPublicKey;
import org.eclipse.equinox.p2.core.UIServices;
import org.robotui.install.InstallWatcher;

/**
 * What p2 asks a user. Only what is not signed is asked about: who has signed with a certificate that this machine does
 * not know is treated as nobody, since a name that nobody vouches for says nothing.
 */
final class TrustPrompt extends UIServices {
  private final InstallWatcher watcher;
  private boolean declined;

  TrustPrompt(InstallWatcher watcher) {
    this.watcher = watcher;
  }

  /** Whether the user did not want what is not signed. */
  boolean declined() {
    return declined;
  }

  @Override
  public TrustInfo getTrustInfo(Certificate[][] chains, String[] unsigned) {
    return getTrustInfo(chains, List.of(), unsigned);
  }

  @Override
  public TrustInfo getTrustInfo(Certificate[][] chains, Collection<PGPPublicKey> keys, String[] unsigned) {
    List<String> files = unsigned == null ? List.of() : Arrays.stream(unsigned).map(TrustPrompt::fileName).toList();
    boolean accepted = watcher.acceptsUnsigned(files);
    declined = !accepted;
    List<Certificate> first =
        chains == null || !accepted ? List.of() : Arrays.stream(chains).map(chain -> chain[0]).toList();
    return new TrustInfo(first, accepted && keys != null ? keys : List.of(), false, accepted);
  }

  private static String fileName(String detail) {
    return detail.substring(detail.lastIndexOf('/') + 1);
  }

  /** Sites that ask for a password are not served: nobody here could keep it. */
  @Override
  public AuthenticationInfo getUsernamePassword(String location) {
    return AUTHENTICATION_PROMPT_CANCELED;
  }

  @Override
  public AuthenticationInfo getUsernamePassword(String location, AuthenticationInfo previous) {
    return AUTHENTICATION_PROMPT_CANCELED;
  }
}
