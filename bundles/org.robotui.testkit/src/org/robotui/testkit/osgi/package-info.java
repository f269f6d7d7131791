/**
 * What tests inside the framework need beside the stand-ins: bundles that are made while they run. Safe for all
 * threads.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.testkit.osgi;
