package org.robotui.install;

import java.net.URI;
import java.util.List;

/**
 * Features of this product, an OSGi service. One call at a time; a second one waits. All calls but those about sites
 * take from parts of a second to minutes and belong on no display thread. A thread that is interrupted is not heard:
 * what p2 has begun, it ends or takes back.
 */
public interface FeatureInstaller {
  /**
   * What is installed and was asked for, which is what can be removed.
   *
   * @return by name; empty where the product was not made by p2, as in an IDE
   */
  List<SiteFeature> installed();

  /**
   * Reads what a site offers.
   *
   * @param site an update site, by {@code http}, {@code https} or {@code file}
   * @return its features, or why it cannot be read
   */
  SiteContent look(URI site);

  /**
   * Installs features, or a newer version of them. The site is remembered where that succeeds.
   *
   * @param site where they are
   * @param features their ids
   * @param watcher follows it
   * @return what has become of it
   */
  InstallOutcome install(URI site, List<String> features, InstallWatcher watcher);

  /**
   * Installs newer versions from the sites that are remembered.
   *
   * @param features ids of those to update; empty for all
   * @param watcher follows it
   * @return what has become of it
   */
  InstallOutcome update(List<String> features, InstallWatcher watcher);

  /**
   * Removes features, and what only they needed. Settings of users stay.
   *
   * @param features their ids
   * @param watcher follows it
   * @return what has become of it
   */
  InstallOutcome remove(List<String> features, InstallWatcher watcher);

  /**
   * The sites that are remembered for this user.
   *
   * @return as they were added
   */
  List<URI> sites();

  /**
   * Remembers a site.
   *
   * @param site to be looked at for updates
   */
  void remember(URI site);

  /**
   * Forgets a site; what was installed from it stays.
   *
   * @param site as remembered
   */
  void forget(URI site);
}
