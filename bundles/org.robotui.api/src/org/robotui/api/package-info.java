/**
 * The contracts between robots' interfaces, views and the core that connects them. No SWT, no framework.
 *
 * <p>A bundle registers one {@link org.robotui.api.ComponentType} service per component; core creates, owns and closes
 * the instances.
 */
@org.osgi.annotation.versioning.Version("1.8.0")
package org.robotui.api;
