/** A server of WebSockets for tests of robot interfaces that are clients of such servers. It needs the JDK alone. */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.testkit.web;
