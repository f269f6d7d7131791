/**
 * The server side of SmartSoft's communication patterns, as far as tests and simulations need it. Each server listens
 * on a port of its own; a {@link org.robotui.smartsoft.server.SmartComponent} enters servers at a naming service.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.smartsoft.server;
