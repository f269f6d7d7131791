/**
 * Recording what robots send: beginning and ending a recording, how it is doing, and keeping the last seconds.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.api.record;
