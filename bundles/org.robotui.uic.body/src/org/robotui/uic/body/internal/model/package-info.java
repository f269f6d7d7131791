/** What is known of a body, and what is shown of it. */
package org.robotui.uic.body.internal.model;
