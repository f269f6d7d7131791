/**
 * Installing, updating and removing while the application runs: features of update sites, by p2. What is installed is
 * started at once; what is removed ends. A call that fails leaves the product as it was. Also watches a folder whose
 * jars are bundles of the running application, which needs no call. Everything that is said is a sentence for users.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.install;
